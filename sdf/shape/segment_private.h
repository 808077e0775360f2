#pragma once
#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace mien {

/// What a shape answers for a point it cannot place: a NaN becomes +infinity, "outside".
inline double outside_if_nan(double d) {
  return d == d ? d : std::numeric_limits<double>::infinity();
}

/// Unsigned distance from p to the segment a b; a == b is a point. Within 4·2⁻⁵² of the larger of
/// |p − a| and |p − b|;
/// +infinity if a coordinate is NaN or infinite.
inline double distance_to_segment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  glm::dvec2 ab = b - a, ap = p - a, bp = p - b;
  double squared = glm::dot(ab, ab), along = glm::dot(ap, ab);
  if (!(squared > 0x1p-900 && squared < 0x1p900 && std::abs(along) < 0x1p900)) {
    const double size = (std::abs(ab.x) + std::abs(ab.y)) + (std::abs(ap.x) + std::abs(ap.y));
    if (size == 0.0) return 0.0;
    if (!std::isfinite(size)) {
      for (glm::dvec2 v : {a, b, p})
        if (!std::isfinite(v.x) || !std::isfinite(v.y))
          return std::numeric_limits<double>::infinity();
      return 16.0 * distance_to_segment(0.0625 * a, 0.0625 * b, 0.0625 * p);  // the sum overflowed
    }
    const double scale = std::ldexp(1.0, std::clamp(std::ilogb(size), -1000, 1000));
    ab /= scale;
    squared = glm::dot(ab, ab);
    along = glm::dot(ap / scale, ab);
  }
  if (!(along > 0.0)) return norm(ap);
  if (along >= squared) return norm(bp);
  const glm::dvec2 full = b - a;
  return along < 0.5 * squared ? norm(ap - (along / squared) * full)
                               : norm(bp + ((squared - along) / squared) * full);
}

}  // namespace mien
