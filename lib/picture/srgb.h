#pragma once
// The sRGB transfer function (IEC 61966-2-1), both ways, in double.

#include <mien/color.h>

#include <cmath>

namespace mien {

/// Linear light of an encoded channel; both 0 … 1.
inline double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The encoded channel of linear light; both 0 … 1. For 1 it is exactly 1, which the power function would
/// miss by a rounding error.
inline double srgb_from_linear(double linear) {
  if (linear >= 1) return 1;
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// The colour whose encoded channels and opacity are given as 0 … 255, as people write them.
inline Color color_from_srgb255(double r, double g, double b, double a = 255) {
  return {linear_from_srgb(r / 255), linear_from_srgb(g / 255), linear_from_srgb(b / 255), a / 255};
}

}  // namespace mien
