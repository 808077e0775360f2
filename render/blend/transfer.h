#pragma once
// Between linear light and the encoded values that files and screens hold (IEC 61966-2-1, sRGB),
// and from real numbers to whole ones.

#include <cmath>
#include <cstdint>

namespace mien {

/// Linear light in [0, 1] to the encoded value in [0, 1]. 1 is 1 exactly, which the power would
/// miss by a rounding.
inline double srgb_from_linear(double v) {
  if (v >= 1.0) return 1.0;
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

/// And back.
inline double linear_from_srgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// The nearest of the levels 0 … top, halves up; values outside [0, 1] are clamped, NaN is 0.
inline int level(double v, int top) {
  return v > 0.0 ? int(std::fmin(v, 1.0) * top + 0.5) : 0;
}

}  // namespace mien
