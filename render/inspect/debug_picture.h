#pragma once
// Pictures of how a picture comes about, for people who want to see why it costs what it costs.

#include <mien/api.h>
#include <mien/image.h>
#include <mien/parallel.h>
#include <mien/scene.h>
#include <mien/view.h>

namespace mien {

enum class DebugPicture : unsigned char {
  /// Every piece of outline, each outline in a colour of its own, on black; ends of pieces are white.
  outlines,
  /// The regions between them, each in a colour of its own.
  regions,
  /// Stretches of outline that are seen, the brighter the more the colour changes across them; dim
  /// where nothing is seen of a piece.
  fragments,
  /// Regions by what they look like: alike is one colour; white dots where the colour varies.
  looks,
  /// The signed distance of the layer whose outline is nearest: blue inside, orange outside, a
  /// darker line every 10 pixels, the outline itself white.
  distance,
  /// The surface's normal where the topmost layer has a relief: (x, y, z) from −1 … 1 to red, green,
  /// blue 0 … 255, y up; everything else is level, (128, 128, 255).
  normals
};

MIEN_API Image debug_picture(const Scene& scene, const View& view, DebugPicture which,
                             const Threads& threads = {});

}  // namespace mien
