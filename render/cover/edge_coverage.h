#pragma once
// How much of a square lies inside a straight edge, in closed form.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {

/// What the form below promises; its test reads this number.
struct EdgeCoverageContract {
  static constexpr double kStraightError = 4e-15;  ///< of straight_edge_coverage, rounding alone
};

/// Area of the unit square inside a straight edge.
///
///   d   signed distance from the square's centre to the edge, in sides; negative: the centre is inside
///   n   unit outward normal of the edge
///   ->  covered area in [0, 1]; NaN in d gives 0 (outside)
///
/// Derivation.  A point of the square is u, uniform on [−1/2, 1/2]²; it is inside when d + n·u < 0. n·u is a sum
/// of two independent uniforms of widths a = max(|n.x|, |n.y|) and b = min(|n.x|, |n.y|), so its density is a
/// trapezoid: 1/a for |s| <= (a−b)/2, falling linearly to 0 at (a+b)/2.
///
///        1/a  ____________
///            /            \          area(d) = P(n·u < −d)
///           /              \                 = 1/2 − d/a                  |d| <= (a−b)/2
///     _____/                \_____           = ((a+b)/2 − d)² / (2ab)     on the right slope
///      −(a+b)/2   0   (a+b)/2                = 1 − area(−d)               on the left slope
///
/// (The common ramp clamp(1/2 − d) is off by up to 0.043, eleven grey levels, at 45°.)
/// Error.  Rounding alone. Source. Derived here; checked against supersampling in the test beside it.
inline double straight_edge_coverage(double d, glm::dvec2 n) {
  const double nx = std::abs(n.x), ny = std::abs(n.y);
  const double a = std::max(nx, ny), b = std::min(nx, ny), t = std::abs(d);
  const double reach = 0.5 * (a + b) - t;  // how far the slope still extends past d
  double outer = 0.0;                      // covered area if d >= 0; also what NaN takes
  if (t <= 0.5 * (a - b))
    outer = 0.5 - t / a;
  else if (reach > 0.0)
    outer = reach * reach / (2.0 * a * b);
  return d < 0.0 ? 1.0 - outer : outer;
}

}  // namespace mien
