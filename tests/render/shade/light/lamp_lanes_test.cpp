#include "render/shade/light/lamp_lanes.h"

#include <gtest/gtest.h>

#include "tests/support/lit_scene.h"

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

}  // namespace
}  // namespace mien
