#pragma once
// Pictures of how a picture comes about, for people who want to see why it costs what it costs.

#include <mien/lib/base/api.h>
#include <mien/lib/base/parallel.h>
#include <mien/render/image.h>
#include <mien/render/view/view.h>
#include <mien/sdf/scene/scene.h>

namespace mien {

enum class DebugPicture : unsigned char {
  /// What became of every square: filled with one colour (blue, the larger the square the darker),
  /// a pixel with one edge (green), several edges (yellow), divided (orange to red, by cells),
  /// varying paint (violet).
  tiles,
  /// The signed distance of the layer whose outline is nearest: blue inside, orange outside, a
  /// darker line every 10 pixels, the outline itself white.
  distance,
  /// How much of a pixel is covered by the topmost layer whose outline crosses it, black to white;
  /// pixels that no outline crosses are dim blue.
  coverage,
  /// The surface's normal where the topmost layer has a relief: (x, y, z) from −1 … 1 to red, green,
  /// blue 0 … 255, y up; everything else is level, (128, 128, 255).
  normals
};

MIEN_API Image debug_picture(const Scene& scene, const View& view, DebugPicture which,
                             const Threads& threads = {});

}  // namespace mien
