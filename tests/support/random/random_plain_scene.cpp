#include "tests/support/random/random_plain_scene.h"

#include <cmath>
#include <random>
#include <vector>

namespace mien::test {
namespace {

/// A shape of a random kind, about the size of the picture (2 × 2 units) or much smaller.
Shape random_shape(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1, 1), unit(0, 1);
  const auto at = [&] { return glm::dvec2{place(random), place(random)}; };
  const double angle = 6.2831853 * unit(random), size = std::pow(10.0, -2 * unit(random));
  const glm::dvec2 way{std::cos(angle), std::sin(angle)};
  const QuadBezier curve{at(), at(), at()};
  switch (int(12 * unit(random))) {
    case 0:
      return HalfPlane{way, 0.5 * place(random)};
    case 1:
      return ParabolaSide{at(), way, 3 * place(random)};
    case 2:
      return Band{{0.3 * at(), way, 2 * unit(random)},
                  {0.3 * at() + 0.5 * way, -way, 2 * unit(random)}};
    case 3:
      return Disc{at(), 0.7 * size};
    case 4:
      return CutDisc{at(), 0.7 * size, unit(random), unit(random), way};
    case 5:
      return Ellipse{at(), {0.8 * size, 0.8 * size * unit(random)}, way};
    case 6:
      return Triangle{at(), at(), at()};
    case 7:
      return Line{at(), at(), 0.1 * size};
    case 8:
      return Polyline{{at(), at(), at(), at()}, 0.1 * size};
    case 9:
      return QuadStroke{curve, 0.2 * size};
    case 10:
      return TaperedStroke{curve,
                           {0.2 * size * unit(random), 0.2 * size, 0.2 * size * unit(random)}};
    default: {
      const glm::dvec2 a = at(), b = at(), c = at();
      return Path{{{{{a, at(), b}, {b, 0.5 * (b + c), c}, {c, at(), a}}}},
                  unit(random) < 0.5 ? FillRule::nonzero : FillRule::even_odd};
    }
  }
}

}  // namespace

Scene random_plain_scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {unit(random), unit(random), unit(random), 1});
  std::vector<Area> areas;
  for (int i = 0; i < 6; ++i) areas.push_back(build.shape(random_shape(random)));
  const auto any = [&] { return areas[std::size_t(unit(random) * double(areas.size()))]; };
  for (int i = 0; i < 5; ++i) {
    switch (int(7 * unit(random))) {
      case 0:
        areas.push_back(build.unite(any(), any()));
        break;
      case 1:
        areas.push_back(build.intersect(any(), any()));
        break;
      case 2:
        areas.push_back(build.subtract(any(), any()));
        break;
      case 3:
        areas.push_back(build.complement(any()));
        break;
      case 4:
        areas.push_back(build.offset(any(), 0.1 * unit(random) - 0.03));
        break;
      case 5:
        areas.push_back(build.shell(any(), 0.05 * unit(random)));
        break;
      default:
        break;
    }
    build.layer(
        "layer", any(),
        {{unit(random), unit(random), unit(random), unit(random) < 0.3 ? unit(random) : 1}});
  }
  return std::move(build).finish();
}

}  // namespace mien::test
