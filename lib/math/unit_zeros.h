#pragma once
// The zeros in [0, 1] of a cubic that is too delicate to be evaluated by its coefficients.

#include "lib/math/bracketed_root.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

/// Which zeros are wanted: all, or those where the function rises through 0 (the minima of its
/// integral).
enum class Zeros { all, rising };

/// Up to three parameters, ascending.
struct UnitZeros {
  int count = 0;
  std::array<double, 3> t{};
};

/// A zero between lo and hi, where f differs in sign: Newton with halving where it is slow. The
/// last step is taken from at most 2⁻³⁰ away, and Newton squares that. Never more than 100
/// evaluations.
template <class F>
double unit_zero_between(const F& f, double lo, double hi, double f_lo, double f_hi) {
  double t = lo + (hi - lo) * std::clamp(f_lo / (f_lo - f_hi), 0.0625, 0.9375);
  double last_step = hi - lo;
  for (int i = 0; i < 100; ++i) {
    const ValueSlope at = f(t);
    if (at.value == 0.0) return t;
    ((at.value < 0.0) == (f_lo < 0.0) ? lo : hi) = t;
    double step = -at.value / at.slope;
    const bool newton = t + step > lo && t + step < hi && std::abs(step) <= 0.5 * last_step;
    if (!newton) step = 0.5 * (lo + hi) - t;
    last_step = std::abs(step);
    t += step;
    if (last_step <= (newton ? 0x1p-30 : 0x1p-54)) return t;
  }
  return t;
}

/// Zeros in [0, 1] of f, a cubic in t with leading coefficients c3, c2, c1 (of t³, t², t). The coefficients
/// only tell where f turns. The values come from `f` itself (t -> ValueSlope), which the caller evaluates
/// in whatever way is accurate. A zero at 0 or 1 is found where f is exactly 0 there.
template <Zeros kWanted, class F>
UnitZeros unit_zeros(double c3, double c2, double c1, const F& f) {
  double knots[4] = {0.0, 1.0, 1.0, 1.0};
  int pieces = 1;
  const double discriminant = c2 * c2 - 3.0 * c3 * c1;
  if (discriminant > 0.0) {
    const double q = -(c2 + std::copysign(std::sqrt(discriminant), c2 + 0.0));  // −0 is 0
    const double x = q / (3.0 * c3), y = c1 / q;
    for (const double m : {std::min(x, y), std::max(x, y)})
      if (m > knots[pieces - 1] && m < 1.0) knots[pieces++] = m;
    knots[pieces] = 1.0;
  }
  UnitZeros zeros;
  double f_lo = f(0.0).value;
  if (f_lo == 0.0 && kWanted == Zeros::all) zeros.t[zeros.count++] = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const double f_hi = f(knots[i + 1]).value;
    if (f_hi == 0.0 && kWanted == Zeros::all) {
      if (zeros.count < 3) zeros.t[zeros.count++] = knots[i + 1];
    } else if ((f_lo < 0.0 && f_hi > 0.0) || (f_lo > 0.0 && f_hi < 0.0)) {
      if ((kWanted == Zeros::all || f_lo < 0.0) && zeros.count < 3)
        zeros.t[zeros.count++] = unit_zero_between(f, knots[i], knots[i + 1], f_lo, f_hi);
    } else if (f_hi == 0.0 && f_lo < 0.0 && zeros.count < 3) {
      zeros.t[zeros.count++] = knots[i + 1];
    }
    f_lo = f_hi;
  }
  return zeros;
}

}  // namespace mien
