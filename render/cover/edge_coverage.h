#pragma once
// How much of a square does one edge cover?  Exact box-filter antialiasing, in closed form.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {

/// What the forms below promise; their tests read these numbers.
struct EdgeCoverageContract {
  static constexpr double kStraightError = 4e-15;  ///< of straight_edge_coverage, rounding alone
  static constexpr double kBentError = 1e-13;      ///< of bent_edge_coverage, rounding alone
  static constexpr double kStraightenedPerBend = 0.25;  ///< of straightened
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

/// Area of the unit square inside a bent edge: where d + n·u + bend/2 (m·u)² <= 0, m = (−n.y, n.x).
///
///   bend   the edge's curvature, in 1 / side; positive where the inside is convex
///
/// Derivation.  By Green, twice the area is the integral of cross(u, du) along the boundary, which is made of
///   pieces of the four sides, each cross(u, du) = 1/2 per unit of length, and of the parabola
///   u(t) = t m − (d + bend t²/2) n, where it is (d − bend t²/2) dt. On a side the condition is a quadratic in the
///   place along it; its roots give both the inside lengths and the t between which the parabola is in the square.
/// Error.  kBentError: rounding alone, for |bend| <= 1. A straight edge moved by the mean of the bend over its chord
///   would be simpler, but is off by up to 0.08·bend where the edge runs along a side of the square (tried).
double bent_edge_coverage(double d, glm::dvec2 n, double bend);

/// The distance of a straight edge near a bent one: moved by the mean of the bend over the
/// tangent's chord [t1, t2] in the square, bend/6 (t1² + t1 t2 + t2²); a tangent that misses the
/// square is held at the corner it comes nearest to. Nowhere farther from the bent edge than
/// |bend|/4.
double straightened(double d, glm::dvec2 n, double bend);

}  // namespace mien
