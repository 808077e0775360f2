#pragma once
#include <mien/quad_bezier.h>
#include <mien/shape.h>

#include <cstddef>

namespace mien {

inline QuadBezier straight(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

/// Whether a side is straight as Path defines it.
inline bool is_straight(const QuadBezier& c) {
  return c.p1 == 0.5 * (c.p0 + c.p2);
}

/// ±1 for every time that a side passes p's height to the right of p.
int passes(const QuadBezier& side, glm::dvec2 p);

/// Unsigned.
double distance_to_side(const QuadBezier& side, glm::dvec2 p);

/// Calls visit for every side of a loop, and for a straight one wherever a side does not begin
/// where the one before ends, so that a loop is closed whatever its numbers.
template <class Visit>
void for_each_side(const Path::Loop& loop, const Visit& visit) {
  if (loop.sides.empty()) return;
  glm::dvec2 end = loop.sides.back().p2;
  for (const QuadBezier& side : loop.sides) {
    if (end != side.p0) visit(straight(end, side.p0));
    visit(side);
    end = side.p2;
  }
}

}  // namespace mien
