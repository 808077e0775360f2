#include <mien/tools/accuracy/reference.h>

#include <algorithm>

#include <mien/tools/accuracy/roots.h>

namespace mien::accuracy {

Quad true_distance(const QuadBezier& c, glm::dvec2 p) {
  const Quad dx = Quad(c.p0.x) - p.x, dy = Quad(c.p0.y) - p.y;
  const Quad ax = Quad(c.p1.x) - c.p0.x, ay = Quad(c.p1.y) - c.p0.y;
  const Quad bx = Quad(c.p2.x) - c.p1.x - ax, by = Quad(c.p2.y) - c.p1.y - ay;
  const Polynomial half_slope{dx * ax + dy * ay, 2 * (ax * ax + ay * ay) + dx * bx + dy * by,
                              3 * (ax * bx + ay * by), bx * bx + by * by};
  const auto square_at = [&](Quad t) {
    const Quad x = dx + t * (2 * ax + t * bx), y = dy + t * (2 * ay + t * by);
    return x * x + y * y;
  };
  Quad least = std::min(square_at(0), square_at(1));
  for (const Quad t : sign_changes(half_slope, 0, 1)) least = std::min(least, square_at(t));
  return square_root(least);
}

}  // namespace mien::accuracy
