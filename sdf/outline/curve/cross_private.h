#pragma once
#include <glm/vec2.hpp>

namespace mien {

inline double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// v turned by a right angle from +x towards +y.
inline glm::dvec2 turned(glm::dvec2 v) {
  return {-v.y, v.x};
}

}  // namespace mien
