#include "tests/support/scenes/huge_scene.h"

#include <utility>
#include <vector>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

class HugeMaker {
 public:
  explicit HugeMaker(std::uint64_t seed) : r_(seed * 6151 + 3) {}

  Scene made() {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, color());
    for (int i = 0; i < 6; ++i) {
      const Area area = build.shape(shape());
      Color c = color();
      if (r_.chance(0.3)) c.a = r_.unit();
      build.layer("layer", r_.chance(0.2) ? build.complement(area) : area, {c});
    }
    return std::move(build).finish();
  }

 private:
  Color color() {
    const double r = r_.unit(), g = r_.unit();
    return {r, g, r_.unit(), 1};
  }

  double coordinate() { return r_.chance(1.0 / 3) ? 6000 * r_.between(-1, 1) : r_.between(-1, 1); }

  glm::dvec2 point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

  double size() { return r_.chance(1.0 / 3) ? 6000 * r_.unit() : r_.size(-2, 0); }

  QuadBezier bow() {
    const glm::dvec2 a = point(), b = point();
    return {a, b, point()};
  }

  Shape shape() {
    const glm::dvec2 p = point();
    switch (r_.below(9)) {
      case 0:
        return Disc{p, size()};
      case 1: {
        const double a = size();
        return Ellipse{p, {a, size()}, r_.direction()};
      }
      case 2:
        return Line{p, point(), 0.1 * size()};
      case 3: {
        const glm::dvec2 a = point(), b = point();
        return Polyline{{p, a, b, point()}, 0.1 * size()};
      }
      case 4: {
        const QuadBezier spine = bow();
        return QuadStroke{spine, 0.1 * size()};
      }
      case 5: {
        const QuadBezier spine = bow();
        const double a = 0.1 * size(), b = 0.1 * size();
        return TaperedStroke{spine, {a, b, 0.1 * size()}};
      }
      case 6:
        return ParabolaSide{p, r_.direction(), r_.between(-3, 3)};
      case 7: {
        const glm::dvec2 a = point();
        return Triangle{p, a, point()};
      }
      default: {
        const glm::dvec2 a = point(), b = point(), c = point();
        return Path{{{{{p, a, b}, {b, 0.5 * (b + c), c}, {c, point(), p}}}},
                    r_.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
      }
    }
  }

  Random r_;
};

}  // namespace

Scene huge_scene(std::uint64_t seed) {
  return HugeMaker(seed).made();
}

}  // namespace mien::test
