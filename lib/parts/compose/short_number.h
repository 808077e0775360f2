#pragma once
// Numbers of composed faces.

#include <glm/vec2.hpp>

#include <cmath>

namespace mien {

/// To a millionth of a face, which is less than any picture shows: as text they stay short.
inline double short_number(double value) {
  return std::round(value * 1e6) / 1e6;
}

inline glm::dvec2 short_pair(glm::dvec2 p) {
  return {short_number(p.x), short_number(p.y)};
}

}  // namespace mien
