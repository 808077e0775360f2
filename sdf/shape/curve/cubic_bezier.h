#pragma once
// How far a point is from a cubic Bézier curve, and where it is nearest.

#include <mien/api.h>
#include <mien/cubic_bezier.h>
#include <mien/quad_bezier_distance.h>

namespace mien {

/// Method. Half the slope of |B(t) − p|² is a quintic. Its Bernstein coefficients are halved until
/// a piece has no
///   sign change (no zero in it) or one (exactly one zero): every minimum is isolated, at most
///   kMaxDepth halvings deep; a cluster closer than that lies where the distance does not change.
///   An isolated one is polished by bracketed Newton on (B − p)·B' itself, not on coefficients.
/// Error. At most 8·2⁻⁵²·S, S = the largest distance from p to a control point. Loops, cusps,
/// collinear and
///   coincident control points included. A NaN or infinite coordinate gives +infinity.
/// Source. Bernstein subdivision (Sederberg and Nishita's root finder in its simplest form); the
/// rest derived here;
///   tests/sdf/shape/curve/cubic_bezier_test.cpp compares with binary128.
MIEN_API double distance(const CubicBezier& curve, glm::dvec2 p);
MIEN_API NearestPoint nearest(const CubicBezier& curve, glm::dvec2 p);

struct CubicBezierContract {
  static constexpr double kError = 8.0 * 0x1p-52;  ///< times S
  static constexpr int kMaxDepth = 40;
  static constexpr int kMaxSplits = 250;
};

}  // namespace mien
