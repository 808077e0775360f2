#pragma once
// The winding number of a path by itself.

#include <mien/shape.h>

#include <vector>

#include "tests/support/real128.h"

namespace mien::test {

/// The winding number by the vertical ray upwards (the code takes a horizontal one), roots in
/// binary128.
inline int winding_upwards(const Path& path, glm::dvec2 p) {
  int count = 0;
  for (const Path::Loop& loop : path.loops)
    for (const QuadBezier& c : loop.sides) {
      const Real a = Real(c.p1.x) - c.p0.x, b = Real(c.p2.x) - c.p1.x - a;
      const Real e = Real(c.p1.y) - c.p0.y, f = Real(c.p2.y) - c.p1.y - e;
      for (const Real t : roots_in({Real(c.p0.x) - p.x, 2 * a, b}, 0, 1)) {
        if (t == 1) continue;  // the next side's
        const Real y = c.p0.y + t * (2 * e + t * f), speed = a + t * b;
        if (y > p.y) count += speed < 0 ? 1 : speed > 0 ? -1 : 0;
      }
    }
  return count;
}

}  // namespace mien::test
