#pragma once
// Amounts as colours: the one spectrum of all heat maps and their bars.

#include <mien/color.h>
#include "lib/picture/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mien {

/// 0 … 1 as sRGB levels: deep blue, blue-green, green, yellow, red; straight lines between, so that
/// brightness rises to yellow and only the very largest turn red.
inline std::array<std::uint8_t, 3> heat_rgb(double amount) {
  constexpr int kColors[5][3] = {
      {38, 44, 120}, {24, 120, 168}, {64, 180, 110}, {246, 214, 70}, {214, 40, 40}};
  const double place = std::clamp(std::isnan(amount) ? 0.0 : amount, 0.0, 1.0) * 4;
  const int i = std::min(int(place), 3);
  std::array<std::uint8_t, 3> rgb;
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = std::uint8_t(
        std::lround(kColors[i][c] + (place - i) * (kColors[i + 1][c] - kColors[i][c])));
  return rgb;
}

/// The same as light.
inline Color heat_color(double amount) {
  const auto rgb = heat_rgb(amount);
  return color_from_srgb255(rgb[0], rgb[1], rgb[2]);
}

}  // namespace mien
