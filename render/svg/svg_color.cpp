#include "render/svg/svg_color.h"
#include "render/svg/path_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien {

std::string svg_color(const Mix& mix) {
  const auto level = [&](double v) {
    return mix.a > 0.0 ? int(std::lround(255.0 * std::clamp(v / mix.a, 0.0, 1.0))) : 0;
  };
  return fmt::format("#{:02x}{:02x}{:02x}", level(mix.r), level(mix.g), level(mix.b));
}

std::string svg_opacity(const char* attribute, double opacity) {
  constexpr int kDecimals = 5;  // finer than 1/65535
  const std::string text = short_decimal(opacity > 0.0 ? std::min(opacity, 1.0) : 0.0, kDecimals);
  return text == "1" ? std::string() : fmt::format(" {}=\"{}\"", attribute, text);
}

}  // namespace mien
