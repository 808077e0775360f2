#include <mien/render/tile/distance_lattice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/random.h"

namespace mien {
namespace {

constexpr int kBlock = DistanceLattice::kBlock;

/// An area in pixels: face units are pixels here.
AreaDistance area_of(const std::function<Area(SceneBuilder&)>& make) {
  SceneBuilder build({.box = {{-100, -100}, {100, 100}}, .y_up = false}, {1, 1, 1, 1});
  const Area area = make(build);
  build.layer("layer", area, {.color = {0, 0, 0, 1}});
  return {std::move(build).finish(), area, Map<PixelSpace, FaceSpace>{}};
}

double worst(const AreaDistance& area, DistanceLattice& lattice, glm::dvec2 begin) {
  double most = 0;
  for (int row = 0; row < kBlock; ++row)
    for (int column = 0; column < kBlock; ++column) {
      const glm::dvec2 p = begin + glm::dvec2{column, row};
      const auto corners = lattice.corners(column, row);
      for (const int k : {0, 1, 2, 3})
        most = std::max(most,
                        std::abs(corners[std::size_t(k)] - area.at(p + glm::dvec2{k % 2, k / 2})));
      most = std::max(most, std::abs(lattice.center(column, row) - area.at(p + 0.5)));
    }
  return most;
}

TEST(DistanceLattice, IsTheDistance) {  // G3
  test::Random random(3);
  double most = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::dvec2 a = random.point(-90, 90), b = random.point(-90, 90),
                     c = random.point(-90, 90);
    const double r = random.between(5, 80), s = random.between(5, 80);
    const AreaDistance area = area_of([&](SceneBuilder& build) {
      const Area ellipse = build.shape(Ellipse{a, {r, s}, random.direction()});
      if (i % 3 == 0) return ellipse;
      const Area stroke = build.shape(TaperedStroke{{a, b, c}, {0.1 * r, 0.2 * s, 0.05 * r}});
      return i % 3 == 1 ? stroke : build.either(build.shape(Disc{c, s}), stroke);
    });
    for (int k = 0; k < 20; ++k) {
      const glm::dvec2 begin{double(kBlock * (random.below(22) - 11)),
                             double(kBlock * (random.below(22) - 11))};
      DistanceLattice lattice;
      lattice.fill(area, begin);
      most = std::max(most, worst(area, lattice, begin));
    }
  }
  EXPECT_LT(most, 1e-10);
}

/// A seam between two half-planes, at every place and angle of a block.
TEST(DistanceLattice, HasEveryKink) {
  test::Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 m = random.direction(), n = random.direction();
    const AreaDistance area = area_of([&](SceneBuilder& build) {
      const glm::dvec2 at = random.point(-1, 9);
      return build.either(build.shape(HalfPlane{m, m.x * at.x + m.y * at.y}),
                          build.shape(HalfPlane{n, n.x * at.x + n.y * at.y}));
    });
    DistanceLattice lattice;
    lattice.fill(area, {0, 0});
    EXPECT_LT(worst(area, lattice, {0, 0}), 1e-10);
  }
}

TEST(DistanceLattice, MirroredIsTheSameBits) {
  const auto disc = [](double x) {
    return area_of([x](SceneBuilder& build) { return build.shape(Disc{{x, 5}, 40}); });
  };
  const AreaDistance left = disc(-13.3), right = disc(13.3);
  DistanceLattice a, b;
  a.fill(left, {-72, 8}), b.fill(right, {64, 8});
  for (int row = 0; row < kBlock; ++row)
    for (int column = 0; column < kBlock; ++column) {
      EXPECT_EQ(a.center(column, row), b.center(kBlock - 1 - column, row));
      const auto one = a.corners(column, row), two = b.corners(kBlock - 1 - column, row);
      EXPECT_EQ(one[0], two[1]);
      EXPECT_EQ(one[2], two[3]);
    }
}

}  // namespace
}  // namespace mien
