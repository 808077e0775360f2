#include "tests/support/scenes/lit_scene.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mien::test {
namespace {

const Map<PixelSpace, FaceSpace> kSame{glm::dmat2{1.0}, glm::dvec2{0.0}};

Path random_blob(Random& random, glm::dvec2 center, double size) {
  Path path;
  path.loops.emplace_back();
  constexpr int kSides = 5;
  std::vector<glm::dvec2> p;
  for (int i = 0; i < kSides; ++i) {
    const double a = 6.283185307 * (i + random.between(-0.2, 0.2)) / kSides;
    p.push_back(center + size * random.between(0.35, 0.5) * glm::dvec2{std::cos(a), std::sin(a)});
  }
  for (int i = 0; i < kSides; ++i) {
    const glm::dvec2 a = p[std::size_t(i)], b = p[std::size_t((i + 1) % kSides)], way = b - a;
    const glm::dvec2 bulge = random.between(-0.12, 0.25) * glm::dvec2{way.y, -way.x};
    path.loops[0].sides.push_back({a, 0.5 * (a + b) + bulge, b});
  }
  return path;
}

}  // namespace

AreaDistance random_area(Random& random, int kind, double size) {
  const glm::dvec2 c = random.point(30.0, 34.0), way = random.direction();
  const glm::dvec2 a = c - 0.4 * size * way, b = c + 0.4 * size * way;
  const glm::dvec2 m = c + 0.3 * size * random.between(-1, 1) * glm::dvec2{way.y, -way.x};
  const auto half = [&] { return size * random.between(0.03, 0.15); };
  SceneBuilder scene({}, {});
  Area area;
  switch (kind) {
    case 0:
      area = scene.shape(TaperedStroke{{a, m, b}, {half(), half(), half()}});
      break;
    case 1:
      area = scene.shape(random_blob(random, c, size));
      break;
    case 2:
      area = scene.shape(
          Ellipse{c, size * glm::dvec2{random.between(0.2, 0.5), random.between(0.1, 0.5)}, way});
      break;
    case 3:
      area = scene.shape(Disc{c, 0.4 * size});
      break;
    case 4:
      area = scene.shape(Line{a, b, half()});
      break;
    case 5:
      area = scene.shape(Triangle{a, b, c + 0.5 * size * glm::dvec2{way.y, -way.x}});
      break;
    case 6:
      area = scene.shape(QuadStroke{{a, m, b}, half()});
      break;
    default:
      area = scene.unite(scene.shape(Disc{a, 0.3 * size}), scene.shape(Disc{b, 0.25 * size}));
  }
  return {std::move(scene).finish(), area, kSame};
}

LitScene random_lit(Random& random, int kind, double size, Profile profile, Blend blend) {
  LitScene made;
  made.distances.push_back(random_area(random, kind, size));
  made.paint.color = mix_from_color(
      {random.between(0, 1), random.between(0, 1), random.between(0, 1), random.below(3) ? 1 : 0.6},
      blend);
  const Light light{.direction = {random.between(-0.7, 0.7), random.between(-0.7, 0.7), 0.8},
                    .ambient = random.between(0.1, 0.5)};
  const double width = size * random.between(0.04, 0.3);
  made.paint.relief = GridRelief{.distance = 0,
                                 .profile = profile,
                                 .width = width,
                                 .height = width * random.between(0.3, 1.2) * random.sign(),
                                 .table = {0, 0.7, 1, 0.9},
                                 .domes = {},
                                 .lamp = Lamp(light, random.below(2) ? 0.3 : 0.0, 30)};
  if (random.below(3) == 0)
    made.paint.relief->domes.push_back({random.point(26, 38),
                                        6.0 / size * glm::dmat2{1, 0.1, -0.1, 1.2},
                                        size * random.between(-0.05, 0.05), 0.3 * size});
  return made;
}

}  // namespace mien::test
