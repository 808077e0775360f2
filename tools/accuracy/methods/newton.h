#pragma once
// Newton's method from the nearest of seventeen samples: what is written first where no closed form is at hand.
//
// Source. P. J. Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems, 1990, 612–626,
// which improves parameters so; the samples are everybody's. Written from the description.

#include "tools/accuracy/methods/foot.h"

namespace mien::accuracy {

template <class T>
T newton_from_samples(const QuadBezier& curve, T x, T y) {
  constexpr int kSamples = 16, kSteps = 8;
  const FootEquation<T> f(curve, x, y);
  T best = f.square(0), t = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const T at = T(i) / kSamples, square = f.square(at);
    if (square < best) best = square, t = at;
  }
  for (int i = 0; i < kSteps; ++i) t = std::clamp(t - f.at(t) / f.slope(t), T(0), T(1));
  return std::sqrt(std::min(best, f.square(t)));
}

}  // namespace mien::accuracy
