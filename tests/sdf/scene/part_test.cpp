#include "sdf/scene/part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

Scene whole() {
  SceneBuilder build({.box = {{0, 0}, {10, 10}}}, {1, 1, 1, 1});
  const Area a = build.shape(Disc{{3, 3}, 2}), b = build.shape(Disc{{5, 3}, 2});
  build.layer("a", a, {{1, 0, 0, 1}});
  build.open_group("outer", 0.5);
  build.layer("both", build.intersect(a, b), {{0, 1, 0, 1}});
  build.open_group("inner", 0.25, b, MixMode::screen);
  build.layer("rest", build.offset(build.shell(build.subtract(build.complement(a), b), 0.5), 0.1),
              {.relief = shared({.area = a, .profile = Profile::bevel})});
  build.close_group();
  build.close_group();
  build.layer("along", build.unite(a, b),
              {.gradient = shared({.along = DistanceGradient{b, 0, 1}, .stops = {{0, {}}}})});
  return std::move(build).finish();
}

TEST(ScenePart, AllLayersAreTheSameScene) {
  const Scene scene = whole();
  ScenePart part;
  const PartLayer all[] = {{0}, {1}, {2}, {3}};
  const Scene copy = part.make(scene, all, scene.canvas());
  ASSERT_EQ(copy.layers().size(), 4u);
  ASSERT_EQ(copy.groups().size(), 2u);
  EXPECT_EQ(copy.groups()[1].parent, 0);
  EXPECT_EQ(copy.groups()[1].opacity, 0.25);
  EXPECT_EQ(copy.groups()[0].mix, MixMode::normal);
  EXPECT_EQ(copy.groups()[1].mix, MixMode::screen);
  Random r(1);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(copy.layers()[i].name, scene.layers()[i].name);
    EXPECT_EQ(copy.layers()[i].group, scene.layers()[i].group);
    for (int k = 0; k < 50; ++k) {
      const glm::dvec2 p = r.point(0, 10);
      EXPECT_EQ(copy.distance(copy.layers()[i].area, p), scene.distance(scene.layers()[i].area, p));
    }
  }
  const glm::dvec2 p{1, 7};
  const Area relief = copy.layers()[2].paint.relief->area;
  EXPECT_EQ(copy.distance(relief, p), scene.distance(scene.layers()[2].paint.relief->area, p));
}

TEST(ScenePart, SomeLayersHaveOnlyWhatTheyNeed) {
  const Scene scene = whole();
  ScenePart part;
  const PartLayer some[] = {{0}, {3}};
  const Scene made = part.make(scene, some, {{{2, 2}, {4, 4}}, false});
  EXPECT_EQ(made.layers().size(), 2u);
  EXPECT_TRUE(made.groups().empty());
  EXPECT_EQ(made.shapes().size(), 2u);  // the shared one once
  EXPECT_FALSE(made.canvas().y_up);
}

TEST(ScenePart, WhatCoversItHasNoOutline) {
  const Scene scene = whole();
  ScenePart part;
  const PartLayer some[] = {{0, PartLayer::In::everywhere}, {2, PartLayer::In::everywhere}};
  const Scene made = part.make(scene, some, scene.canvas());
  for (const Layer& layer : made.layers())
    EXPECT_EQ(made.distance(layer.area, {1e9, 0}), -HUGE_VAL);
  const glm::dvec2 p{1, 7};  // the relief goes by its own area
  EXPECT_EQ(made.distance(made.layers()[1].paint.relief->area, p),
            scene.distance(scene.layers()[2].paint.relief->area, p));
}

TEST(ScenePart, MakesAreasOfTheStepsThatAreLeft) {
  const Scene scene = whole();
  ScenePart part;
  const PartStep steps[] = {
      {Op::shape, 0, 0.25}, {Op::shape, 1}, {Op::complement}, {Op::intersect}};
  const PartLayer some[] = {{1, PartLayer::In::steps, steps}, {3}};
  const Scene made = part.make(scene, some, scene.canvas());
  EXPECT_EQ(made.shapes().size(), 2u);  // shared with the layer that stays as it is
  Random r(2);
  for (int k = 0; k < 50; ++k) {
    const glm::dvec2 p = r.point(0, 10);
    EXPECT_EQ(made.distance(made.layers()[0].area, p),
              std::max(distance(scene.shapes()[0], p) - 0.25, -distance(scene.shapes()[1], p)));
  }
}

}  // namespace
}  // namespace mien::test
