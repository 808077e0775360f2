#pragma once
// One root between two numbers at which a function has opposite signs: Newton's method, with halving where
// it is slow.

#include <cmath>
#include <cstdint>
#include <limits>
#include "lib/base/bit_cast.h"

namespace mien {

/// A function's value and slope at a point, and the size below which the value is only rounding.
struct ValueSlope {
  double value, slope, noise = 0.0;
};

/// The number halfway between lo and hi in the order of the floating-point numbers: halving by it
/// reaches neighbours in at most 64 steps, however far apart lo and hi are.
inline double middle_by_rank(double lo, double hi) {
  const auto rank = [](double x) {
    const auto bits = mien::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const std::int64_t a = rank(lo), b = rank(hi), down = (a & b) + ((a ^ b) >> 1);
  const std::int64_t m = down < 0 ? down + ((a ^ b) & 1) : down;  // towards 0: mirror images alike
  return mien::bit_cast<double>(m < 0 ? std::numeric_limits<std::int64_t>::min() - m : m);
}

/// A root of f in (lo, hi), where f has the sign of `sign_lo` at lo and the opposite one at hi. `f` maps x
/// to ValueSlope. Ends at a value within its noise, at a Newton step below one ulp, at neighbouring
/// numbers, or after `max_evaluations` (at least every third step halves, and 64 halvings are enough).
template <class F>
double bracketed_root(const F& f, double lo, double hi, double sign_lo, double start,
                      int max_evaluations) {
  double x = start > lo && start < hi ? start : middle_by_rank(lo, hi);
  for (int i = 1; i < max_evaluations; ++i) {
    const ValueSlope at = f(x);
    if (std::abs(at.value) <= at.noise) return x;
    ((at.value < 0.0) == (sign_lo < 0.0) ? lo : hi) = x;
    double next = x - at.value / at.slope;
    if (std::abs(next - x) <= 0x1p-53 * std::abs(x)) return x;
    if (!(next > lo && next < hi) || (i >= 12 && i % 3 == 0)) {
      next = middle_by_rank(lo, hi);
      if (!(next > lo && next < hi)) return x;
    }
    x = next;
  }
  return x;
}

}  // namespace mien
