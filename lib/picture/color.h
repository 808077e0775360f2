#pragma once
#include <glm/vec4.hpp>

namespace mien {

/// A colour: LINEAR red, green and blue (sRGB primaries) and opacity, not premultiplied. White is
/// 1, 1, 1, 1.
struct Color {
  double r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Color&, const Color&) = default;
};

}  // namespace mien
