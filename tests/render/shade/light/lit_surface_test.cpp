#include "render/shade/light/lit_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/lit_scene.h"

namespace mien {
namespace {

TEST(LitSurface, HasAZoneBetweenTwoKinksOfItsProfile) {
  test::Random random(3);
  auto scene = test::random_lit(random, 3, 60, Profile::custom, Blend::srgb);
  GridRelief& relief = *scene.paint.relief;
  relief.width = 6, relief.height = 3, relief.table = {0, 1, 1, 0};
  const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
  ASSERT_EQ(surface.zones(), 5);
  const double depths[] = {-1, 1, 3, 5, 7};
  for (int zone = 0; zone < 5; ++zone) {
    EXPECT_EQ(surface.zone_of(-depths[zone]), zone);
    EXPECT_NEAR(surface.rise(zone, depths[zone]), relief.rise(depths[zone]), 1e-12) << zone;
  }
  EXPECT_TRUE(surface.flat(0) && surface.flat(2) && surface.flat(4));
  EXPECT_FALSE(surface.flat(1) || surface.flat(3));
}

TEST(LitSurface, KnowsTheGradientOfItsDistance) {
  test::Random random(4);
  for (int kind = 0; kind < test::kLitShapes; ++kind) {
    const auto scene = test::random_lit(random, kind, 40, Profile::bevel, Blend::srgb);
    const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
    const glm::dvec2 p = random.point(20, 44);
    const Outward at = surface.outward(p);
    EXPECT_NEAR(glm::length(at.normal), 1.0, 1e-9);
    EXPECT_NEAR(surface.outward(p + 0.01 * at.normal).d, at.d + 0.01, 1e-3);
  }
}

TEST(LitSurface, IsLitAsTheReliefIs) {
  test::Random random(5);
  for (int k = 0; k < 60; ++k) {
    const auto scene = test::random_lit(random, k % test::kLitShapes, 40, Profile(1 + k % 3),
                                        k % 2 ? Blend::srgb : Blend::linear);
    const Blend blend = k % 2 ? Blend::srgb : Blend::linear;
    const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
    const glm::dvec2 p = random.point(20, 44);
    const Outward at = surface.outward(p);
    if (std::abs(at.d) < 0.02) continue;  // where the relief's law allows for outlines' errors
    const GridRelief& relief = *scene.paint.relief;
    const Mix want = relief.lamp.lit(scene.paint.color, relief.slope(p, at.d, at.normal), blend);
    const Mix got = surface.color(surface.zone_of(at.d), p, at);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(got[i], want[i], 1e-9) << k;
  }
}

}  // namespace
}  // namespace mien
