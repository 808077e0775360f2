#pragma once
// Ramps of up to a dozen stops, some of them at one place, of every extension.

#include <cstddef>

#include "render/blend/ramp.h"
#include "tests/support/random/random.h"

namespace mien::test {

inline Gradient random_gradient(Random& r) {
  const bool clear = r.between(0, 1) < 0.3;
  Gradient gradient{LinearGradient{{0, 0}, {1, 0}}, {}, Extend(int(r.between(0, 2.999)))};
  const int count = int(r.between(2, 13));
  double at = r.between(-0.5, 0.5);
  for (int i = 0; i < count; ++i) {
    gradient.stops.push_back(
        {at, {r.between(0, 1), r.between(0, 1), r.between(0, 1), clear ? r.between(0, 1) : 1.0}});
    if (r.between(0, 1) < 0.6) at += r.between(0.01, 0.4);
  }
  if (!(gradient.stops.back().at > gradient.stops.front().at)) gradient.stops.back().at += 0.3;
  return gradient;
}

inline Ramp random_ramp(Random& r) {
  return Ramp(random_gradient(r), 1, Blend::srgb);
}

}  // namespace mien::test
