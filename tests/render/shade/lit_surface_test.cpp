#include <mien/render/shade/lit_surface.h>

#include <gtest/gtest.h>

#include "tests/support/lit_scene.h"

namespace mien {
namespace {

TEST(LitSurface, ZonesLieBetweenTheProfilesKinks) {
  test::Random random(1);
  test::LitScene scene = test::random_lit(random, 3, 40, Profile::custom, Blend::srgb);
  scene.paint.relief->width = 9;
  const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
  ASSERT_EQ(surface.levels().size(), 4u);
  EXPECT_EQ(surface.levels()[1], -3.0);
  EXPECT_EQ(surface.zone_of(0.5), 0);
  EXPECT_EQ(surface.zone_of(-4.0), 2);
  EXPECT_EQ(surface.zone_of(-9.5), 4);
  EXPECT_TRUE(surface.flat(0) && surface.flat(4));
  EXPECT_FALSE(surface.flat(2));
}

TEST(LitSurface, IsLitAsTheReliefAndTheLampSay) {
  test::Random random(2);
  for (int k = 0; k < 400; ++k) {
    const Blend blend = k % 2 ? Blend::srgb : Blend::linear;
    const auto scene = test::random_lit(random, random.below(test::kLitShapes), 40,
                                        Profile(random.below(4)), blend);
    const glm::dvec2 center{3, -2}, p = random.point(20, 44);
    const LitSurface surface(scene.paint, scene.distances, blend, center);
    const Outward o = surface.outward(p + center);
    const glm::dvec2 slope = scene.paint.relief->slope(p, o.d, o.normal);
    const Mix expected = scene.paint.relief->lamp.lit(scene.paint.color, slope, blend);
    const Mix got = surface.color(surface.zone_of(o.d), p + center, o);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(got[i], expected[i], 1e-6) << k;
  }
}

}  // namespace
}  // namespace mien
