#pragma once
#include <mien/box2.h>

#include <string>

namespace mien {

/// What the picture of a face shows, and the units of its numbers.
struct FaceCanvas {
  Box2 box{{-0.5, -0.5}, {0.5, 0.5}};  ///< finite, not empty
  bool y_up = true;                    ///< whether larger y is higher in the picture
  double mirror_x = 0;                 ///< left and right mirror each other about x = mirror_x
  std::string unit = "face units";     ///< the unit's name, for people

  /// x of a point and of its mirror image add up to this.
  double twice_axis() const { return 2 * mirror_x; }
};

}  // namespace mien
