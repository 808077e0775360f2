#pragma once
// The winding number of a path by itself.

#include <mien/shape.h>

#include <cmath>
#include <optional>
#include <utility>

#include "tests/support/exact/real128.h"

namespace mien::test {

/// What a side adds, if doubles leave no doubt: no root close to an end or a turn, none beside p.
inline std::optional<int> surely_passed_upwards(const QuadBezier& c, glm::dvec2 p) {
  constexpr double kSure = 1e-7;
  const double from = c.p0.x - p.x, a = c.p1.x - c.p0.x, b = c.p2.x - c.p1.x - a;
  const double e = c.p1.y - c.p0.y, f = c.p2.y - c.p1.y - e;
  const double size = std::abs(from) + std::abs(a) + std::abs(b) + std::abs(c.p0.y - p.y) +
                      std::abs(e) + std::abs(f);
  const double under = a * a - from * b;
  if (!(std::abs(under) > kSure * size * size)) return std::nullopt;
  if (under < 0) return 0;
  const double q = -(a + std::copysign(std::sqrt(under), a));
  int count = 0;
  for (const auto& [over, by] : {std::pair{q, b}, std::pair{from, q}}) {
    if (std::abs(over) > 2 * std::abs(by)) continue;  // far beyond the ends
    const double t = over / by, y = c.p0.y + t * (2 * e + t * f) - p.y, speed = a + t * b;
    if (!(std::abs(t) > kSure && std::abs(t - 1) > kSure)) return std::nullopt;
    if (t < 0 || t > 1) continue;
    if (!(std::abs(y) > kSure * size && std::abs(speed) > kSure * size)) return std::nullopt;
    if (y > 0) count += speed < 0 ? 1 : -1;
  }
  return count;
}

/// The winding number by the vertical ray upwards (the code takes a horizontal one), in doubt by roots in binary128. The
/// ray is 1e-13 to the right of p, where no side ends or turns.
inline int winding_upwards(const Path& path, glm::dvec2 p) {
  const Real ray = Real(p.x) + Real(1e-13);
  int count = 0;
  for (const Path::Loop& loop : path.loops)
    for (const QuadBezier& c : loop.sides) {
      if (const auto sure = surely_passed_upwards(c, p)) {
        count += *sure;
        continue;
      }
      const Real a = Real(c.p1.x) - c.p0.x, b = Real(c.p2.x) - c.p1.x - a;
      const Real e = Real(c.p1.y) - c.p0.y, f = Real(c.p2.y) - c.p1.y - e;
      for (const Real t : roots_in({c.p0.x - ray, 2 * a, b}, 0, 1)) {
        if (t == 1) continue;  // the next side's
        const Real y = c.p0.y + t * (2 * e + t * f), speed = a + t * b;
        if (y > p.y) count += speed < 0 ? 1 : speed > 0 ? -1 : 0;
      }
    }
  return count;
}

}  // namespace mien::test
