#pragma once
// The stroke of varying width: the nearest of its discs.

#include <mien/shape.h>

namespace mien {

struct NearestDisc {
  double distance;  ///< signed: |p − spine(t)| − w(t), the smallest over all t
  double t;         ///< its parameter, in [0, 1]
};

/// Method. Let L be a guess of the smallest distance. Then |p − B(t)| − w(t) >= L for all t if and only
///   if the quartic P(t) = |p − B(t)|² − (w(t) + L)² is >= 0 wherever w + L > 0. Its minima lie at 0, at
///   1 and at the roots of the cubic P', all of which are found. The lowest of them gives the next
///   L = |p − B| − w. The first L comes from the spine's nearest point and the ends. L then falls to the
///   minimum at least as fast as Newton's method. Each step is global: if no candidate is lower, no
///   point is. There are never more than kMaxSteps steps.
/// Error. At most 8·2⁻⁵²·S, S = the largest distance from p to a control point + the largest half-width.
///   Exact outside and on the outline. Inside it is the depth in the deepest disc, which is a bound.
/// Source. Derived here (a Dinkelbach iteration). tests/sdf/shape/curve/tapered_stroke_test.cpp compares
///   with dense search in binary128.
MIEN_API NearestDisc nearest(const TaperedStroke& stroke, glm::dvec2 p);

struct TaperedStrokeContract {
  static constexpr double kError = 8.0 * 0x1p-52;  ///< times S
  static constexpr int kMaxSteps = 60;
};

}  // namespace mien
