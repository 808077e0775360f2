#pragma once
// The stroke of varying width: which of its discs is nearest.

#include <mien/shape.h>

namespace mien {

struct NearestDisc {
  double distance;  ///< signed: |p − spine(t)| − w(t), the smallest over all t
  double t;         ///< parameter in [0, 1] where it is
};

/// Method. For a guess L of the smallest distance, |p − B(t)| − w(t) >= L for all t if and only if
/// the
///   quartic P(t) = |p − B(t)|² − (w(t) + L)² is >= 0 wherever w + L > 0. Its minima are at 0, 1
///   and at zeros of P', a cubic whose every zero is found; |p − B| − w at the lowest is the next
///   L. Starting at the nearest point of the spine and the ends, L falls to the minimum, at least
///   as fast as Newton's method, and when no candidate is lower, none exists: each step is global.
///   Never more than kMaxSteps.
/// Error. At most 8·2⁻⁵²·S, S = the largest distance from p to a control point + the largest
/// half-width.
///   Exact outside and on the outline; inside, the depth in the deepest disc: a bound.
/// Source. Derived here (a Dinkelbach iteration); tests/sdf/shape/curve/tapered_stroke_test.cpp compares
/// with
///   dense search in binary128.
MIEN_API NearestDisc nearest(const TaperedStroke& stroke, glm::dvec2 p);

struct TaperedStrokeContract {
  static constexpr double kError = 8.0 * 0x1p-52;  ///< times S
  static constexpr int kMaxSteps = 60;
};

}  // namespace mien
