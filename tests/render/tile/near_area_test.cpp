#include <mien/render/tile/near_area.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace mien {
namespace {

Area random_shape(SceneBuilder& build, test::Random& random, int kind) {
  const auto point = [&] { return random.point(-90, 90); };
  const double r = random.between(3, 40), s = random.between(3, 40);
  switch (kind) {
    case 0:
      return build.shape(Ellipse{point(), {r, s}, random.direction()});
    case 1:
      return build.shape(TaperedStroke{{point(), point(), point()}, {0.1 * r, 0.2 * s, 0.05 * r}});
    case 2:
      return build.shape(QuadStroke{{point(), point(), point()}, 0.2 * r});
    case 3:
      return build.shape(Disc{point(), r});
    case 4:
      return build.shape(ParabolaSide{point(), random.direction(), 0.3 / r});
    default: {
      Path path;
      path.rule = random.below(2) ? FillRule::nonzero : FillRule::even_odd;
      std::vector<glm::dvec2> p;
      for (int i = 0; i < 7; ++i) p.push_back(point());
      Path::Loop loop;
      for (std::size_t i = 0; i < 7; ++i) {
        const glm::dvec2 a = 0.5 * (p[i] + p[(i + 1) % 7]),
                         b = 0.5 * (p[(i + 1) % 7] + p[(i + 2) % 7]);
        const bool is_straight = random.below(4) == 0;
        loop.sides.push_back({a, is_straight ? 0.5 * (a + b) : p[(i + 1) % 7], b});
      }
      path.loops.push_back(loop);
      return build.shape(path);
    }
  }
}

/// An area in pixels: face units are pixels here.
AreaDistance random_area(test::Random& random) {
  SceneBuilder build({.box = {{-100, -100}, {100, 100}}, .y_up = false}, {1, 1, 1, 1});
  Area area = random_shape(build, random, random.below(6));
  for (int i = random.below(4); i > 0; --i) {
    const Area other = random_shape(build, random, random.below(6));
    switch (random.below(5)) {
      case 0:
        area = build.either(area, other);
        break;
      case 1:
        area = build.both(area, other);
        break;
      case 2:
        area = build.without(other, area);
        break;
      case 3:
        area = build.shell(build.either(other, area), 2);
        break;
      default:
        area = build.complement(build.offset(area, random.between(-3, 3)));
    }
  }
  build.layer("layer", area, {.color = {0, 0, 0, 1}});
  return {std::move(build).finish(), area, Map<PixelSpace, FaceSpace>{}};
}

TEST(NearArea, IsTheAreasDistanceInItsDisc) {  // G3
  test::Random random(5);
  NearArea near;
  std::size_t left = 0, all = 0;
  for (int i = 0; i < 400; ++i) {
    const AreaDistance area = random_area(random);
    const glm::dvec2 center = random.point(-100, 100);
    const double radius = i % 3 ? 11.4 : 1.5;
    near.narrow(area, center, radius);
    left += near.node_count(), all += area.nodes().size();
    std::vector<float> x, y;
    for (int k = 0; k < 40; ++k) {
      const glm::dvec2 u =
          random.direction() * (k == 0 ? radius : radius * std::sqrt(random.between(0, 1)));
      x.push_back(float(u.x)), y.push_back(float(u.y));
    }
    std::vector<float> d(x.size());
    near.distances(x, y, d);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const glm::dvec2 p = center + glm::dvec2{x[k], y[k]};
      EXPECT_NEAR(near.at(p), area.at(p), 1e-9) << i;
      EXPECT_NEAR(d[k], area.at(p), 4e-4) << i;  // 4 · 2⁻²³ · some hundred pixels
    }
  }
  EXPECT_LT(left, all);
}

TEST(NearArea, LeavesOneSideOfARoundPath) {
  SceneBuilder build({.box = {{-100, -100}, {100, 100}}, .y_up = false}, {1, 1, 1, 1});
  Path path;
  path.loops.emplace_back();
  const auto at = [](int i) {
    return 80.0 * glm::dvec2{std::cos(0.3927 * i), std::sin(0.3927 * i)};
  };
  for (int i = 0; i < 16; i += 2)
    path.loops[0].sides.push_back({at(i), 1.05 * at(i + 1), at((i + 2) % 16)});
  const Area area = build.shape(path);
  const AreaDistance distance(std::move(build).finish(), area, Map<PixelSpace, FaceSpace>{});
  NearArea near;
  near.narrow(distance, 0.8 * at(1), 5);
  EXPECT_EQ(near.side_count(), 1u);
  near.narrow(distance, {0, 0}, 5);
  EXPECT_EQ(near.side_count(), 8u);
}

TEST(NearArea, OfATreeOfAnyDepth) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}, .y_up = false}, {1, 1, 1, 1});
  Area many = build.shape(Disc{{0, 0}, 0.01});
  for (int i = 1; i < 100'000; ++i) many = build.offset(many, i % 2 ? 1 : -1);
  const AreaDistance distance(std::move(build).finish(), many, Map<PixelSpace, FaceSpace>{});
  NearArea near;
  near.narrow(distance, {3, 4}, 1);
  EXPECT_NEAR(near.at({3, 4}), 5 - 0.01 - 1, 1e-9);
}

}  // namespace
}  // namespace mien
