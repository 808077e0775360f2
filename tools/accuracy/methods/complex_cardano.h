#pragma once
// Cardano's formula in complex numbers, one branch for all cubics. The real parts of all three roots are tried: a point of
// the curve is never too near.
//
// Source. G. Cardano, Ars magna, 1545, in the form of M. Abramowitz and I. A. Stegun, Handbook of Mathematical
// Functions, 1964, 3.8.2. Written from the formula.

#include "tools/accuracy/methods/foot.h"

#include <complex>

namespace mien::accuracy {

template <class T>
T complex_cardano(const QuadBezier& curve, T x, T y) {
  using C = std::complex<T>;
  const FootEquation<T> f(curve, x, y);
  const T a2 = f.c2 / f.c3, a1 = f.c1 / f.c3, a0 = f.c0 / f.c3;
  const T q = a1 / 3 - a2 * a2 / 9, r = (a1 * a2 - 3 * a0) / 6 - a2 * a2 * a2 / 27;
  const C root = std::sqrt(C(q * q * q + r * r));
  const C plus = r + root, minus = r - root;
  // The larger of the two, and the other by their product, −q.
  const C s1 = std::pow(std::abs(plus) > std::abs(minus) ? plus : minus, T(1) / 3);
  const C s2 = std::abs(s1) > 0 ? -q / s1 : C(0);
  const T half = (s1 + s2).real() / 2;
  const T apart = (C(0, std::sqrt(T(3)) / 2) * (s1 - s2)).real();
  const T best = std::min({f.square(2 * half - a2 / 3), f.square(apart - half - a2 / 3),
                           f.square(-apart - half - a2 / 3)});
  return std::sqrt(best);
}

}  // namespace mien::accuracy
