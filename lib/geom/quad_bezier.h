#pragma once
// The quadratic Bézier curve, of which mien's pen lines are made.

#include <glm/vec2.hpp>

namespace mien {

/// B(t) = (1−t)² p0 + 2t(1−t) p1 + t² p2, t in [0, 1].
struct QuadBezier {
  glm::dvec2 p0, p1, p2;
  friend bool operator==(const QuadBezier&, const QuadBezier&) = default;
};

/// The point at parameter t, by the monomial form p0 + t(2a + t b), a = p1 − p0, b = p0 − 2p1 + p2.
inline glm::dvec2 point(const QuadBezier& c, double t) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  return c.p0 + t * (2.0 * a + t * b);
}

/// dB/dt at t.
inline glm::dvec2 tangent(const QuadBezier& c, double t) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  return 2.0 * (a + t * b);
}

/// d²B/dt², constant.
inline glm::dvec2 bend(const QuadBezier& c) {
  return 2.0 * ((c.p2 - c.p1) - (c.p1 - c.p0));
}

/// The same curve run backwards.
inline QuadBezier reversed(const QuadBezier& c) {
  return {c.p2, c.p1, c.p0};
}

}  // namespace mien
