#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {

/// The length of v: within 2 ulp, and no overflow or underflow on the way (the square root of the
/// sum of squares where that is safe, else hypot).
inline double norm(glm::dvec2 v) {
  const double squared = v.x * v.x + v.y * v.y;
  if (squared > 1e-280 && squared < 1e300) return std::sqrt(squared);
  return std::hypot(v.x, v.y);
}

/// The larger of |x| and |y|.
inline double larger_side(glm::dvec2 v) {
  return std::max(std::abs(v.x), std::abs(v.y));
}

}  // namespace mien
