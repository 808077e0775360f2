#pragma once
// Outlines looked at from a point: how often they wind around it, and what lies at a place of a
// piece. Slow and plain; shares nothing with what sweeps them.

#include "sdf/outline/outlines.h"
#include "sdf/shape/curve/path.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien::test {

inline glm::dvec2 point(const OutlinePiece& p, double t) {
  return {p.x0 + t * (2.0 * p.ax + t * p.bx), p.y0 + t * (2.0 * p.ay + t * p.by)};
}

/// Where a piece passes height y, by halving: y runs one way.
inline double x_at(const OutlinePiece& p, double y) {
  double lo = 0.0, hi = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (lo + hi);
    (point(p, t).y <= y ? lo : hi) = t;
  }
  return point(p, 0.5 * (lo + hi)).x;
}

/// How often an outline winds around q, by the ray to the left.
inline int winding(const Outlines& outlines, int outline, glm::dvec2 q) {
  int count = 0;
  for (const OutlinePiece& p : outlines.pieces) {
    if (p.outline != outline || !(p.y0 <= q.y && q.y < p.y1)) continue;
    const double lo = std::min(p.x0, p.x1), hi = std::max(p.x0, p.x1);
    if (hi < q.x || (lo <= q.x && test::x_at(p, q.y) < q.x)) count += p.turn;
  }
  return count;
}

inline bool is_inside(const Outlines& outlines, int outline, glm::dvec2 q) {
  return mien::is_inside(outlines.rules[outline], winding(outlines, outline, q));
}

}  // namespace mien::test
