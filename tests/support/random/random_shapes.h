#pragma once
// Single shapes by chance, in and around a window of 64 px.

#include <mien/shape.h>

#include <cstdint>
#include <glm/vec2.hpp>

#include "tests/support/random/random.h"

namespace mien::test {

/// Numbers by chance or on a lattice, where everything meets everything.
class RandomShapes {
 public:
  explicit RandomShapes(std::uint64_t seed) : r(seed) {}

  Shape next() {
    lattice_ = r.chance(0.3);
    switch (r.below(12)) {
      case 0:
        return HalfPlane{r.direction(), r.between(-30, 80)};
      case 1:
        return side();
      case 2: {
        const ParabolaSide lower = side();
        ParabolaSide upper = side();
        if (r.chance(0.6)) upper.axis = -lower.axis;
        return Band{lower, upper};
      }
      case 3:
        return Disc{point(), width()};
      case 4:
        return CutDisc{point(), width(), r.between(0, 1.2), r.between(0, 1.2), r.direction()};
      case 5:
        return Ellipse{point(), {width(), width()}, r.direction()};
      case 6:
        return Triangle{point(), point(), point()};
      case 7:
        return Line{point(), point(), width()};
      case 8: {
        Polyline s{{}, width()};
        for (int i = 0, n = 1 + r.below(8); i < n; ++i) s.points.push_back(point());
        return s;
      }
      case 9:
        return QuadStroke{curve(), width()};
      case 10:
        return TaperedStroke{curve(), {width(), width(), width()}};
      default:
        return path();
    }
  }

  Random r;

 private:
  glm::dvec2 point() {
    if (lattice_) return 8.0 * glm::dvec2(r.below(9), r.below(9));
    return r.point(-8, 72);
  }
  double width() { return lattice_ ? 4.0 * r.below(4) : r.between(0, 16); }
  ParabolaSide side() { return {point(), r.direction(), r.sign() * r.size(-3, 1)}; }
  /// Every third one turns back on a straight line.
  QuadBezier curve() {
    if (!r.chance(0.3)) return {point(), point(), point()};
    const glm::dvec2 c = point(), way = lattice_ ? glm::dvec2(8, 8) : 20.0 * r.direction();
    const auto on = [&] { return c + (lattice_ ? r.below(5) - 2 : r.between(-1, 1)) * way; };
    return {on(), on(), on()};
  }
  Path path() {
    Path s{{}, r.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
    for (int l = 1 + r.below(2); l > 0; --l) {
      Path::Loop& loop = s.loops.emplace_back();
      const glm::dvec2 first = point();
      glm::dvec2 a = first;
      for (int i = 2 + r.below(4); i > 0; --i) {
        const glm::dvec2 b = i == 1 ? first : point();
        loop.sides.push_back({a, r.chance(0.5) ? 0.5 * (a + b) : point(), b});
        a = b;
      }
    }
    return s;
  }

  bool lattice_ = false;
};

}  // namespace mien::test
