#pragma once
// Bisection between samples of f that differ in sign: slow, and safe but for two roots between neighbours.
//
// Source. W. H. Press et al., Numerical Recipes, 3rd edition, 2007, section 9.1. Written from the description.

#include "tools/accuracy/methods/foot.h"

#include <limits>

namespace mien::accuracy {

template <class T>
T bisection(const QuadBezier& curve, T x, T y) {
  constexpr int kSamples = 32;
  const FootEquation<T> f(curve, x, y);
  T best = std::min(f.square(0), f.square(1));
  for (int i = 0; i < kSamples; ++i) {
    T lo = T(i) / kSamples, hi = T(i + 1) / kSamples;
    if (!(f.at(lo) <= 0 && f.at(hi) >= 0)) continue;  // towards a minimum f rises
    for (int step = 0; step < std::numeric_limits<T>::digits; ++step) {
      const T middle = (lo + hi) / 2;
      (f.at(middle) <= 0 ? lo : hi) = middle;
    }
    best = std::min(best, f.square((lo + hi) / 2));
  }
  return std::sqrt(best);
}

}  // namespace mien::accuracy
