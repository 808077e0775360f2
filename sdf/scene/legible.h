#pragma once
// A scene as it reads when it is small: no line thinner than a least width, and less of what has hardly an area.

#include <mien/scene.h>

namespace mien {

/// The scene for a picture in which `least` [face units] is the least width of a line; 0: as it is.
///
/// Lines (strokes of every kind and ribbons along outlines) become so wide where they are thickest, and keep their form;
/// but none becomes more than three times as wide: a line that would still be thinner fades instead, in proportion. A
/// shape whose box is smaller than a square of `least` fades with its area. So what is seen of a line or a shape never
/// grows as the picture gets smaller. Where areas are combined, the smaller counts of an intersection and the larger of
/// a union. Clips, shadows and distances that paints read follow the lines as they are drawn.
Scene legible_scene(const Scene& scene, double least);

}  // namespace mien
