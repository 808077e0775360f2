#pragma once
// Distance from a point to a quadratic Bézier curve, and the nearest point on it.
//
//   distance(curve, p)          unsigned distance to the curve
//   nearest(curve, p)           the same, with the nearest point and its parameter
//   critical_points(curve, p)   every parameter where the distance is stationary
//
// Total: every input has a defined result, including collinear or coincident control points, curves of
// zero length, and points on the curve or at a centre of curvature. A NaN or infinite coordinate gives
// distance +infinity.

#include <mien/api.h>
#include <mien/box2.h>
#include <mien/quad_bezier.h>

#include <array>
#include <glm/vec2.hpp>

namespace mien {

struct NearestPoint {
  double distance;   ///< >= 0
  double t;          ///< parameter in [0, 1]
  glm::dvec2 point;  ///< the curve at t
};

/// Parameters in [0, 1] where p − B(t) is perpendicular to the curve, ascending. An end is included
/// only if it is perpendicular too.
struct CriticalPoints {
  int count = 0;
  std::array<double, 3> t{};
};

/// The distance from p to the curve.
///
/// Method. Half the derivative of |B(t) − p|² is a cubic, f = (B − p)·(B'/2). Its coefficients only
///   give the intervals on which f is monotone. f itself is evaluated as the dot product, whose
///   rounding error is a few 2⁻⁵³·S·|B'/2|, and every sign change is refined by bracketed Newton. A
///   pair of roots lost to rounding lies where the distance hardly changes. The end points are always
///   candidates.
/// Error. At most 4·2⁻⁵²·S, S = the largest distance from p to a control point.
/// Source. Derived here; checked against binary128 in tests/sdf/shape/curve/quad_bezier_test.cpp.
MIEN_API double distance(const QuadBezier& curve, glm::dvec2 p);

MIEN_API NearestPoint nearest(const QuadBezier& curve, glm::dvec2 p);

MIEN_API CriticalPoints critical_points(const QuadBezier& curve, glm::dvec2 p);

struct QuadBezierContract {
  static constexpr double kError = 4.0 * 0x1p-52;  ///< times S
};

/// The smallest box around the curve, up to rounding; never smaller than the curve.
MIEN_API Box2 bounds(const QuadBezier& curve);

/// The smallest radius of curvature on the curve: infinite for a straight one, 0 for one that turns
/// back on itself.
MIEN_API double smallest_curvature_radius(const QuadBezier& curve);

}  // namespace mien
