#include <mien/render/tile/plan.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Plan, KnowsWhereLayersCanBe) {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{10, 0}, 5}), other = build.shape(Disc{{-20, 0}, 5});
  build.layer("one", disc, {{0, 0, 0, 1}});
  build.layer("either", build.either(disc, other), {{0, 0, 0, 0.5}});
  build.layer("both", build.both(disc, other), {{0, 0, 0, 1}});
  build.layer("not", build.complement(disc), {{0, 0, 0, 1}});
  const Tape tape = tape_from_scene(std::move(build).finish(), {.width = 100, .height = 100});
  const Plan plan(tape, Depth::u8);
  ASSERT_EQ(plan.layer_boxes.size(), 4u);  // top to bottom
  EXPECT_TRUE(plan.layer_boxes[0].contains({1e9, 1e9}));
  EXPECT_TRUE(plan.layer_boxes[1].empty());
  EXPECT_TRUE(plan.layer_boxes[2].contains({-20, 0}));
  EXPECT_FALSE(plan.layer_boxes[2].contains({0, 20}));
  EXPECT_TRUE(plan.layer_boxes[3].contains({14, 0}));
  EXPECT_FALSE(plan.layer_boxes[3].contains({-20, 0}));
}

TEST(Plan, AllowsLessErrorWhereLevelsAreFinerOrEncodedSteeply) {
  SceneBuilder build({}, {});
  const Scene scene = std::move(build).finish();
  const Tape encoded = tape_from_scene(scene, {.blend = Blend::srgb});
  const Tape linear = tape_from_scene(scene, {.blend = Blend::linear});
  EXPECT_LT(Plan(linear, Depth::u8).tolerance, Plan(encoded, Depth::u8).tolerance);
  EXPECT_LT(Plan(encoded, Depth::u16).tolerance, Plan(encoded, Depth::u8).tolerance);
}

}  // namespace
}  // namespace mien
