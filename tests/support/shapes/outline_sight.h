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

/// The chain that a piece belongs to.
inline const OutlineChain& chain_of(const Outlines& o, const OutlinePiece& p) {
  const int i = int(&p - o.pieces.data());
  return *std::find_if(o.chains.begin(), o.chains.end(),
                       [&](const OutlineChain& c) { return i <= c.last; });
}

/// How often an outline winds around q, by the ray to the left: what crosses it, and what has left the picture through
/// the left side above.
inline int winding(const Outlines& outlines, int outline, glm::dvec2 q) {
  int count = 0;
  for (const OutlineChain& c : outlines.chains)
    for (int i = c.first; c.outline == outline && i <= c.last; ++i) {
      const OutlinePiece& p = outlines.pieces[std::size_t(i)];
      if (!(p.y0 <= q.y && q.y < p.y1)) continue;
      const double lo = std::min(p.x0, p.x1), hi = std::max(p.x0, p.x1);
      if (hi < q.x || (lo <= q.x && test::x_at(p, q.y) < q.x)) count += c.turn;
    }
  for (const OutlineEnd& e : outlines.ends)
    if (const OutlineChain& c = outlines.chains[std::size_t(e.chain)];
        c.outline == outline && e.other < 0 && e.x == outlines.left && e.x < q.x && e.y <= q.y)
      count += e.begins ? -c.turn : c.turn;
  return count;
}

inline bool is_inside(const Outlines& outlines, int outline, glm::dvec2 q) {
  return mien::is_inside(outlines.rules[outline], winding(outlines, outline, q));
}

}  // namespace mien::test
