#pragma once
// The quadratic Bézier curve itself: how far a point is from it, and where it is nearest.
//
//   distance(curve, p)          unsigned distance to the curve
//   nearest(curve, p)           the same, with the nearest point and its parameter
//   critical_points(curve, p)   every parameter where the distance is stationary
//
// Total: collinear and coincident control points, zero length, points on the curve or at a centre
// of curvature are all right. A NaN or infinite coordinate gives distance +infinity.

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

/// Parameters in [0, 1] where p − B(t) is perpendicular to the curve, ascending; ends only if they
/// are so.
struct CriticalPoints {
  int count = 0;
  std::array<double, 3> t{};
};

/// The distance from p to the curve.
///
/// Method. Half the slope of |B(t) − p|² is a cubic, f = (B − p)·(B'/2). It is never solved through
/// its
///   coefficients: they only give the pieces on which it is monotone; f is evaluated as that dot
///   product, whose rounding is a few 2⁻⁵³·S·|B'/2|, and a sign change is followed by bracketed
///   Newton. A root pair lost to rounding lies where the distance hardly changes. The end points
///   are always candidates.
/// Error. At most 4·2⁻⁵²·S, S = the largest distance from p to a control point.
/// Source. Derived here; checked against binary128 in tests/sdf/shape/curve/quad_bezier_test.cpp.
MIEN_API double distance(const QuadBezier& curve, glm::dvec2 p);

MIEN_API NearestPoint nearest(const QuadBezier& curve, glm::dvec2 p);

MIEN_API CriticalPoints critical_points(const QuadBezier& curve, glm::dvec2 p);

struct QuadBezierContract {
  static constexpr double kError = 4.0 * 0x1p-52;  ///< times S
};

/// The smallest box around the curve, to within rounding (and never smaller).
MIEN_API Box2 bounds(const QuadBezier& curve);

/// The smallest radius of curvature on the curve; infinite where it is straight, 0 where it turns
/// back.
MIEN_API double smallest_curvature_radius(const QuadBezier& curve);

}  // namespace mien
