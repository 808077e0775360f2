#pragma once
// From the encoded values that files and screens hold (lib/picture/srgb.h) to whole levels.

#include "lib/picture/srgb.h"

#include <cmath>

namespace mien {

/// The nearest of the levels 0 … top, halves up; values outside [0, 1] are clamped, NaN is 0.
inline int level(double v, int top) {
  return v > 0.0 ? int(std::fmin(v, 1.0) * top + 0.5) : 0;
}

}  // namespace mien
