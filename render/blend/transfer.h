#pragma once
// From the encoded values that files and screens hold (lib/picture/srgb.h) to whole levels.

#include "lib/picture/srgb.h"

#include <cmath>

namespace mien {

/// The nearest of the levels 0 … top, halves up; values outside [0, 1] are clamped, NaN is 0.
inline int level(double v, int top) {
  return v > 0.0 ? int(std::fmin(v, 1.0) * top + 0.5) : 0;
}

/// How steeply a value in linear light is encoded: the factor by which an error there shows in a picture. 12.92 in
/// the dark, 0.44 at 1.
inline double encoding_slope(double linear) {
  return linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1.0 / 2.4 - 1.0);
}

}  // namespace mien
