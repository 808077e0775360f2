#include "render/shade/light/lamp_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes/lit_scene.h"

namespace mien {
namespace {

TEST(LampLanes, LeaveOutDomesThatDoNotReach) {
  test::Random random(32);
  auto scene = test::random_lit(random, 3, 40, Profile::bevel, Blend::srgb);
  auto& domes = scene.paint.relief->domes;
  domes.assign(1, {{10, 10}, glm::dmat2{0.25, 0, 0, 0.25}, 2.0, 4.0});
  const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
  LampLanes lamp;
  set_lamp(surface, 1, {30, 10}, 13, lamp);
  EXPECT_TRUE(lamp.domes.empty());
  set_lamp(surface, 1, {26, 10}, 13, lamp);
  ASSERT_EQ(lamp.domes.size(), 1u);
  EXPECT_EQ(lamp.domes[0].x, -16.0f);
}

/// What squares of the mean must be finer than: the narrower of a dome's two radii, or the highlight on its top.
TEST(LampLanes, KnowHowNarrowDomesAndTheirHighlightsAre) {
  test::Random random(33);
  auto scene = test::random_lit(random, 3, 40, Profile::bevel, Blend::srgb);
  GridRelief& relief = *scene.paint.relief;
  relief.domes.assign(1, {{10, 10}, glm::dmat2{0.25, 0, 0, 0.5}, 2.0, 4.0});
  LampLanes lamp;
  const auto set = [&](double specular) {
    relief.lamp = Lamp(Light{.direction = {-0.3, 0.5, 0.8}, .ambient = 0.3}, specular, 30);
    set_lamp(LitSurface(scene.paint, scene.distances, Blend::srgb, {0, 0}), 1, {10, 10}, 8, lamp);
  };
  set(0);
  EXPECT_EQ(lamp.shine, 0.0f);
  EXPECT_EQ(lamp.finest, 2.0f);
  EXPECT_EQ(lamp.domes.at(0).height, -8.0f);
  EXPECT_EQ(lamp.domes.at(0).foot, 1.0f) << "half of 1 in the steeper direction";
  set(0.3);
  EXPECT_NEAR(lamp.finest, 4.0 / (4.0 * 2.0 * std::sqrt(30.0)), 1e-6);
  // As good as flat: its foot shows no kink.
  relief.domes[0].height = 1e-5;
  set(0);
  EXPECT_EQ(lamp.domes.at(0).foot, 0.0f);
}

/// A highlight that is not seen ahead is a power of 2 that lanes can hold.
TEST(LampLanes, HoldHighlightsThatAreDarkAhead) {
  test::Random random(34);
  auto scene = test::random_lit(random, 3, 40, Profile::bevel, Blend::srgb);
  scene.paint.relief->lamp = Lamp(Light{.direction = {1, 0, 0.01}, .ambient = 0.3}, 0.5, 1e4);
  LampLanes lamp;
  set_lamp(LitSurface(scene.paint, scene.distances, Blend::srgb, {0, 0}), 1, {10, 10}, 8, lamp);
  EXPECT_EQ(lamp.level_shine, 0.0f);
  EXPECT_EQ(lamp.level_power, -126.0f);
}

}  // namespace
}  // namespace mien
