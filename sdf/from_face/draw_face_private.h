#pragma once
// A face as the beginning of a scene, to which more can be added.

#include <mien/face.h>
#include <mien/scene.h>

namespace mien {

/// A scene of the face's canvas and background.
SceneBuilder begin_face(const Face& face);
/// The face's layers, bottom to top, and its light; every group closed.
void draw_face(const Face& face, SceneBuilder& build);

}  // namespace mien
