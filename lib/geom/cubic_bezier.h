#pragma once
// The cubic Bézier curve, as most drawing programs use it.

#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>

namespace mien {

/// B(t) = (1−t)³ p0 + 3t(1−t)² p1 + 3t²(1−t) p2 + t³ p3, t in [0, 1].
struct CubicBezier {
  glm::dvec2 p0, p1, p2, p3;
};

/// The point at parameter t, by de Casteljau's rule.
inline glm::dvec2 point(const CubicBezier& c, double t) {
  const double s = 1.0 - t;
  const glm::dvec2 a = s * c.p0 + t * c.p1, b = s * c.p1 + t * c.p2, d = s * c.p2 + t * c.p3;
  return s * (s * a + t * b) + t * (s * b + t * d);
}

/// dB/dt at t.
inline glm::dvec2 tangent(const CubicBezier& c, double t) {
  const double s = 1.0 - t;
  const glm::dvec2 a = c.p1 - c.p0, b = c.p2 - c.p1, d = c.p3 - c.p2;
  return 3.0 * (s * (s * a + t * b) + t * (s * b + t * d));
}

/// The same curve run backwards.
inline CubicBezier reversed(const CubicBezier& c) {
  return {c.p3, c.p2, c.p1, c.p0};
}

/// The cubic form of a quadratic curve.
inline CubicBezier elevated(const QuadBezier& c) {
  return {c.p0, c.p0 + (2.0 / 3.0) * (c.p1 - c.p0), c.p2 + (2.0 / 3.0) * (c.p1 - c.p2), c.p2};
}

}  // namespace mien
