#include "tests/support/random/scene_dice.h"

namespace mien::test {

Shape random_shape(Dice& dice) {
  const double size = std::pow(10.0, -1.5 * dice.unit());
  const glm::dvec2 way = dice.way(), a = dice.place(), b = dice.place(), c = dice.place(),
                   d = dice.place();
  const double w = dice.unit(), v = dice.unit();
  switch (dice.below(12)) {
    case 0:
      return HalfPlane{way, 0.5 * a.x};
    case 1:
      return ParabolaSide{a, way, 3 * b.x};
    case 2:
      return Band{{0.3 * a, way, 2 * w}, {0.3 * b + 0.5 * way, -way, 2 * v}};
    case 3:
      return Disc{a, 0.7 * size};
    case 4:
      return CutDisc{a, 0.7 * size, w, v, way};
    case 5:
      return Ellipse{a, {0.8 * size, 0.8 * size * (0.05 + 0.95 * w)}, way};
    case 6:
      return Triangle{a, b, c};
    case 7:
      return Line{a, b, 0.1 * size};
    case 8:
      return Polyline{{a, b, c, d}, 0.1 * size};
    case 9:
      return QuadStroke{{a, b, c}, 0.2 * size};
    case 10:
      return TaperedStroke{{a, b, c}, {0.2 * size * w, 0.2 * size, 0.2 * size * v}};
    default:
      return Path{{{{{a, d, b}, {b, 0.5 * (b + c), c}, {c, dice.place(), a}}}},
                  dice.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
  }
}

Gradient random_gradient(Dice& dice, Area own, Area other) {
  Gradient made{.along = LinearGradient{dice.place(), dice.place()},
                .stops = {},
                .extend = Extend(dice.below(3))};
  const int kind = dice.below(3);
  if (kind == 1)
    made.along =
        RadialGradient{dice.place(), {dice.between(0.2, 1), dice.between(0.2, 1)}, dice.way()};
  if (kind == 2) {
    const double from = dice.between(-0.5, 0.3);
    made.along =
        DistanceGradient{dice.chance(0.5) ? own : other, from, from + dice.between(0.2, 0.8)};
  }
  double at = 0;
  const int stops = 2 + dice.below(3);
  for (int i = 0; i < stops; ++i) {
    made.stops.push_back({at, dice.color(0.3)});
    if (dice.chance(0.8) || i == 0) at += dice.between(0.1, 0.6);
  }
  return made;
}

Area any_of(Dice& dice, const std::vector<Area>& areas) {
  return areas[std::size_t(dice.below(int(areas.size())))];
}

void combine_randomly(Dice& dice, SceneBuilder& build, std::vector<Area>& areas) {
  const Area a = any_of(dice, areas), b = any_of(dice, areas);
  switch (dice.below(7)) {
    case 0:
      areas.push_back(build.unite(a, b));
      break;
    case 1:
      areas.push_back(build.intersect(a, b));
      break;
    case 2:
      areas.push_back(build.subtract(a, b));
      break;
    case 3:
      areas.push_back(build.complement(a));
      break;
    case 4:
      areas.push_back(build.offset(a, dice.between(-0.03, 0.07)));
      break;
    case 5:
      areas.push_back(build.shell(a, dice.between(0.01, 0.05)));
      break;
    default:
      break;
  }
}

}  // namespace mien::test
