// Item G9: the areas of a bevel, against counting points.

#include <gtest/gtest.h>

#include "render/effect/bevel.h"

#include <random>

namespace mien {
namespace {

TEST(Bevel, AreasAreThoseOfCountedPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  for (int test = 0; test < 300; ++test) {
    const double side = 2 + 5 * uniform(random), bevel = 0.5 * side * uniform(random);
    const double u0 = uniform(random) * (side - 1), v0 = uniform(random) * (side - 1);
    const double u1 = u0 + uniform(random), v1 = v0 + uniform(random);
    const BevelAreas areas = bevel_areas(u0, u1, v0, v1, side, bevel);
    double counted[5] = {};
    constexpr int kGrid = 200;
    for (int j = 0; j < kGrid; ++j)
      for (int i = 0; i < kGrid; ++i) {
        const double u = u0 + (u1 - u0) * (i + 0.5) / kGrid, v = v0 + (v1 - v0) * (j + 0.5) / kGrid;
        const double edge[] = {bevel, v, u, side - u, side - v};
        int nearest = 0;
        for (int k = 1; k < 5; ++k)
          if (edge[k] < edge[nearest]) nearest = k;
        counted[nearest] += (u1 - u0) * (v1 - v0) / (kGrid * kGrid);
      }
    const double found[] = {areas.flat, areas.above, areas.left, areas.right, areas.below};
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(found[k], counted[k], 0.01) << test << " " << k;
  }
}

TEST(Bevel, NoBevelIsFlat) {
  const BevelAreas areas = bevel_areas(0, 1, 0, 1, 4, 0);
  EXPECT_EQ(areas.flat, 1);
  EXPECT_EQ(areas.above + areas.left + areas.right + areas.below, 0);
}

}  // namespace
}  // namespace mien
