#pragma once
// An eye as a body: what gaze, blink and lids mean for it. Plain data; lib/rig moves it.
//
// Behind the drawn eye stands a ball of a centre and a radius, seen straight from the front: a point
// at the distance r of its centre in the picture is √(R² − r²) in front of it. Its numbers are
// slices, named after the eye ("eyeball.left/radius"), so whatever moves the vector moves the ball.

#include <mien/side.h>

#include <string>
#include <vector>

namespace mien {

/// How a lid gives way to the cornea under it; lib/rig/eye/bulge.h has both laws.
enum class BulgeLaw : unsigned char { native, compat };

/// A point of the face that stays where it is on the edge of a lid. The edge is a quadratic Bézier;
/// (a, b) are the arguments of its polar form at which the point stands: a = b on the curve, a < b
/// the control point of the part from a to b.
struct LidRider {
  int slice;
  bool upper;
  double a, b;
};

struct Eye {
  std::string name;  ///< "eyeball.left"
  Side side = Side::none;

  int center, radius;           ///< slices of the ball: a point, and a length > 0 at rest
  double depth = 0;             ///< of its centre: towards the viewer is positive [face units]
  int cornea = -1, bulge = -1;  ///< slices: height of the cap, height of the push; −1: none
  BulgeLaw law = BulgeLaw::native;

  int gaze_x = -1, gaze_y = -1;  ///< channels: where the iris is beside its rest [face units]
  double reach_x, reach_y;       ///< half-axes of the ellipse the gaze stays in [face units]

  int upper = -1, lower = -1;  ///< slices of the lids: bends of an opening, or parabolas; −1: none
  int inner = -1, outer = -1;       ///< slices of the canthi; −1: the lids are parabolas
  int shifts = -1;                  ///< as in OpeningFigure
  double follow_upper[2] = {0, 0};  ///< share of the gaze, x and y, that a lid's middle follows
  double follow_lower[2] = {0, 0};
  int blink = -1, bias = -1;  ///< channels
  double meet = 1;            ///< where lids meet at bias 0: 0 at the upper, 1 at the lower

  /// First of four slices in a row, the dome that the cornea raises on what lies over it: centre,
  /// radii, height, tilt; −1: none.
  int dome = -1;

  int crease = -1;  ///< slice of the bend of the fold above the upper lid; −1: none
  double crease_rise = 0, crease_fall = 0;  ///< shares of the lid's way up, and down
  std::vector<LidRider> riders;
};

}  // namespace mien
