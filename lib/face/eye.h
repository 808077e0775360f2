#pragma once
// An eye as a body: its ball, gaze, blink and lids. Plain data; lib/rig moves it.
//
// Behind the drawn eye is a ball of radius R, seen from the front. A point of the picture at the distance r
// from its centre is √(R² − r²) in front of the centre. The ball's numbers are slices, named after the eye
// ("eyeball.left/radius"), so whatever moves the vector moves the ball.

#include <mien/index.h>
#include <mien/side.h>

#include <string>
#include <vector>

namespace mien {

struct Channel;

/// How a lid yields to the cornea under it; lib/rig/eye/bulge.h has both laws.
enum class BulgeLaw : unsigned char { native, compat };

/// A point of the face that keeps its place on the edge of a lid. The edge is a quadratic Bézier, and the
/// point is the value of its polar form (blossom) at (a, b): a point of the curve for a = b, and for a < b
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
  double depth = 0;             ///< of its centre, positive towards the viewer [face units]
  int cornea = -1, bulge = -1;  ///< slices: the heights of the cap and of the push; −1: none
  BulgeLaw law = BulgeLaw::native;

  Index<Channel> gaze_x, gaze_y;  ///< offset of the iris from rest [face units]
  double reach_x, reach_y;        ///< half-axes of the ellipse the gaze stays in [face units]

  int upper = -1, lower = -1;  ///< slices of the lids: bends of an opening, or parabolas; −1: none
  int inner = -1, outer = -1;       ///< slices of the canthi; −1: the lids are parabolas
  int shifts = -1;                  ///< as in OpeningFigure
  double follow_upper[2] = {0, 0};  ///< share of the gaze, x and y, that a lid's middle follows
  double follow_lower[2] = {0, 0};
  Index<Channel> blink, bias;
  double meet = 1;  ///< where lids meet at bias 0: 0 at the upper, 1 at the lower

  /// The first of four consecutive slices of the dome that the cornea raises on what covers it: centre,
  /// radii, height, tilt; −1: none.
  int dome = -1;

  int crease = -1;  ///< slice of the bend of the fold above the upper lid; −1: none
  double crease_rise = 0, crease_fall = 0;  ///< shares of the lid's way up, and down
  std::vector<LidRider> riders;
};

}  // namespace mien
