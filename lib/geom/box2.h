#pragma once
#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

namespace mien {

// Some of GLM's configuration macros change its vector types. mien's interface uses the default ones.
static_assert(std::is_same_v<glm::dvec2, glm::vec<2, double, glm::highp>> &&
                  std::is_same_v<glm::length_t, int> && sizeof(glm::dvec2) == 2 * sizeof(double) &&
                  sizeof(glm::dvec3) == 3 * sizeof(double) &&
                  alignof(glm::dvec3) == alignof(double),
              "mien needs GLM's default types: neither GLM_FORCE_DEFAULT_ALIGNED_GENTYPES nor "
              "GLM_FORCE_SIZE_T_LENGTH");

/// An axis-aligned box; sides may be infinite. The default one is empty (lo > hi).
struct Box2 {
  glm::dvec2 lo{std::numeric_limits<double>::infinity()};
  glm::dvec2 hi{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y); }
  glm::dvec2 size() const { return hi - lo; }
  glm::dvec2 center() const { return 0.5 * (lo + hi); }
  bool contains(glm::dvec2 p) const {
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y;
  }
};

/// The smallest box around a box and a point, or around two boxes.
inline Box2 around(Box2 b, glm::dvec2 p) {
  return {{std::min(b.lo.x, p.x), std::min(b.lo.y, p.y)},
          {std::max(b.hi.x, p.x), std::max(b.hi.y, p.y)}};
}
inline Box2 around(Box2 a, const Box2& b) {
  return b.empty() ? a : around(around(a, b.lo), b.hi);
}

/// The intersection of two boxes; empty if they have nothing in common.
inline Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y)},
          {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y)}};
}

/// Grown by `amount` on every side.
inline Box2 grown(Box2 b, double amount) {
  return {b.lo - amount, b.hi + amount};
}

}  // namespace mien
