#pragma once
#include <algorithm>
#include <glm/vec2.hpp>
#include <limits>

namespace mien {

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

/// The smallest box around a box and a point, or two boxes.
inline Box2 around(Box2 b, glm::dvec2 p) {
  return {{std::min(b.lo.x, p.x), std::min(b.lo.y, p.y)},
          {std::max(b.hi.x, p.x), std::max(b.hi.y, p.y)}};
}
inline Box2 around(Box2 a, const Box2& b) {
  return b.empty() ? a : around(around(a, b.lo), b.hi);
}

/// What two boxes have in common; empty if nothing.
inline Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y)},
          {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y)}};
}

/// Grown by `amount` on every side.
inline Box2 grown(Box2 b, double amount) {
  return {b.lo - amount, b.hi + amount};
}

}  // namespace mien
