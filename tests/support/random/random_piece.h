#pragma once
// Monotone pieces of outline, by dice.

#include "sdf/arrange/piece_place.h"

#include <glm/vec2.hpp>

#include "tests/support/random/random.h"

namespace mien::test {

/// From `top` to `bottom`, with the control point at (s, t) of the box of both: 0 and 0 at the top,
/// 1 and 1 at the bottom. Straight where s == t == ½.
inline OutlinePiece piece_between(glm::dvec2 top, glm::dvec2 bottom, double s = 0.5,
                                  double t = 0.5) {
  const glm::dvec2 way = bottom - top;
  OutlinePiece p{.x0 = top.x, .y0 = top.y, .x1 = bottom.x, .y1 = bottom.y};
  p.ax = s * way.x, p.ay = t * way.y;
  p.bx = s == 0.5 && t == 0.5 ? 0.0 : way.x - 2.0 * p.ax;
  p.by = s == 0.5 && t == 0.5 ? 0.0 : way.y - 2.0 * p.ay;
  return p;
}

/// Somewhere in (0, side)², with every kind of bend: none, some, a corner's.
inline OutlinePiece random_piece(Random& r, double side) {
  glm::dvec2 a = r.point(0, side), b = r.point(0, side);
  if (a.y > b.y) std::swap(a, b);
  if (r.chance(0.1)) b.x = a.x;
  if (r.chance(0.3)) return piece_between(a, b);
  const double s = r.chance(0.2) ? r.below(2) : r.unit(), t = r.chance(0.2) ? r.below(2) : r.unit();
  return piece_between(a, b, s, t);
}

}  // namespace mien::test
