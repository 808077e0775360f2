#pragma once
// Distance from a point to a cubic Bézier curve, and the nearest point on it.

#include <mien/api.h>
#include <mien/cubic_bezier.h>
#include <mien/quad_bezier_distance.h>

namespace mien {

/// Method. Half the derivative of |B(t) − p|² is a quintic. Its Bernstein form is bisected until each
///   interval has no sign change, hence no root, or one, hence exactly one root. This isolates every
///   minimum in at most kMaxDepth bisections; roots that are closer together lie where the distance does
///   not change. Each isolated root is refined by bracketed Newton on (B − p)·B' itself, not on
///   coefficients.
/// Error. At most 8·2⁻⁵²·S, S = the largest distance from p to a control point. This includes loops,
///   cusps, and collinear or coincident control points. A NaN or infinite coordinate gives +infinity.
/// Source. Bernstein subdivision (the simplest form of Sederberg and Nishita's root finder); the rest is
///   derived here. tests/sdf/shape/curve/cubic_bezier_test.cpp compares with binary128.
MIEN_API double distance(const CubicBezier& curve, glm::dvec2 p);
MIEN_API NearestPoint nearest(const CubicBezier& curve, glm::dvec2 p);

struct CubicBezierContract {
  static constexpr double kError = 8.0 * 0x1p-52;  ///< times S
  static constexpr int kMaxDepth = 40;
  static constexpr int kMaxSplits = 250;
};

}  // namespace mien
