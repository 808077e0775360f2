#include "render/reference/layer_logic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_plain_scene.h"

namespace mien::test {
namespace {

Reach reach_of(const Scene& scene, const LevelSet& s, glm::dvec2 p, double reach) {
  if (!(s.level > -HUGE_VAL)) return Reach::none;
  const double d = distance(scene.shapes()[std::size_t(s.shape)], p) - s.level;
  return d < -reach ? Reach::whole : d <= reach ? Reach::part : Reach::none;
}

/// Which layers hold a place, by the scopes around it.
std::vector<char> held(const Scene& scene, LayerLogic& logic, const LayerLogic::Scope& scope,
                       glm::dvec2 p) {
  std::vector<char> inside(logic.sets().size()), layers(scene.layers().size());
  for (const int set : logic.open_sets(scope))
    inside[std::size_t(set)] =
        reach_of(scene, logic.sets()[std::size_t(set)], p, 0.0) != Reach::none;
  for (const LiveLayer& live : logic.live(scope))
    layers[std::size_t(live.layer)] = logic.holds(live, inside);
  return layers;
}

void expect_layers_as_distances_say(const Scene& scene, double side, std::uint64_t seed) {
  LayerLogic logic(scene, std::vector<char>(scene.layers().size()));
  Random r(seed);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 p = scene.canvas().box.lo + r.point(0, side);
    std::vector<LayerLogic::Scope> scopes{logic.whole_picture()};
    for (double reach = side; reach > 1e-3 * side; reach *= 0.3)
      scopes.push_back(logic.enter(
          scopes.back(), [&](int s) { return reach_of(scene, logic.sets()[s], p, reach); }));
    for (std::size_t n = 1; n < scopes.size(); ++n) {
      const LayerLogic::Scope& scope = scopes[n];
      const std::vector<char> layers = held(scene, logic, scope, p);
      for (std::size_t k = 0; k < layers.size(); ++k) {
        const double d = scene.distance(scene.layers()[k].area, p);
        if (std::abs(d) < 1e-9) continue;  // on an outline, or on a seam within
        ASSERT_EQ(bool(layers[k]), d < 0.0) << "layer " << k << " at " << p.x << ' ' << p.y;
      }
    }
    for (std::size_t k = scopes.size(); --k > 0;) logic.leave(scopes[k]);
  }
}

TEST(LayerLogic, EveryScopeSaysWhatTheDistanceSays) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_layers_as_distances_say(random_plain_scene(seed), 2, seed);
    expect_layers_as_distances_say(degenerate_scene(seed, 1e-3), 16, seed);
  }
}

TEST(LayerLogic, WhatLiesUnderAnOpaqueLayerIsDropped) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {0, 0, 0, 1});
  build.layer("under", build.shape(Disc{{0.5, 0.5}, 0.2}), {{1, 1, 1, 1}});
  build.layer("all", build.everywhere(), {{1, 0, 0, 1}});
  build.layer("over", build.shape(Disc{{0.5, 0.5}, 0.2}), {{1, 1, 1, 1}});
  const Scene scene = std::move(build).finish();
  LayerLogic logic(scene, {0, 1, 0});
  const auto scope = logic.enter(logic.whole_picture(), [&](int s) {
    return reach_of(scene, logic.sets()[std::size_t(s)], {0.3, 0.5}, 0.05);
  });
  ASSERT_EQ(logic.live(scope).size(), 2u);
  EXPECT_EQ(logic.live(scope)[0].layer, 1);
  EXPECT_EQ(logic.live(scope)[0].count, 0);
  EXPECT_EQ(logic.open_sets(scope).size(), 1u);
  EXPECT_EQ(logic.live(scope)[1].layer, 2);
}

TEST(LayerLogic, OperandsOfWhatIsDecidedAreNotAskedAbout) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {0, 0, 0, 1});
  const Area a = build.shape(Disc{{0, 0}, 1}), b = build.shape(Disc{{0, 0}, 2});
  build.layer("both", build.intersect(a, b), {{1, 1, 1, 1}});
  const Scene scene = std::move(build).finish();
  LayerLogic logic(scene, {0});
  ASSERT_EQ(logic.sets().size(), 2u);
  const auto one_open = logic.enter(logic.whole_picture(), [&](int s) {
    return logic.sets()[std::size_t(s)].shape == 0 ? Reach::part : Reach::whole;
  });
  EXPECT_EQ(logic.open_sets(one_open).size(), 1u);
  logic.leave(one_open);
  const auto none = logic.enter(logic.whole_picture(), [&](int s) {
    return logic.sets()[std::size_t(s)].shape == 0 ? Reach::part : Reach::none;
  });
  EXPECT_TRUE(logic.live(none).empty());
  EXPECT_TRUE(logic.open_sets(none).empty());
}

TEST(LayerLogic, SeamsBetweenAreasThatAbutAreNoOutlines) {  // there a min of distances is 0
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {0, 0, 0, 1});
  const Area left = build.shape(HalfPlane{{1, 0}, 0.5});
  build.layer("all", build.unite(left, build.complement(left)), {{1, 1, 1, 1}});
  const Scene scene = std::move(build).finish();
  LayerLogic logic(scene, {1});
  std::vector<char> inside(logic.sets().size());
  for (const char side : {char{0}, char{1}}) {
    inside.assign(inside.size(), side);
    EXPECT_TRUE(logic.holds(logic.live(logic.whole_picture())[0], inside));
  }
}

TEST(LayerLogic, ShapesWithoutAreaAreNowhere) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {0, 0, 0, 1});
  for (const Shape& shape :
       {Shape(Line{{0, 0}, {1, 1}, 0.0}), Shape(Disc{{0.5, 0.5}, -0.0}),
        Shape(Ellipse{{0.5, 0.5}, {0.3, 0.0}}), Shape(QuadStroke{{{0, 0}, {1, 0}, {1, 1}}, 0.0})})
    build.layer("thin", build.shape(shape), {{1, 1, 1, 1}});
  const Scene scene = std::move(build).finish();
  LayerLogic logic(scene, std::vector<char>(4));
  for (const LevelSet& s : logic.sets()) EXPECT_EQ(s.level, -HUGE_VAL);
}

}  // namespace
}  // namespace mien::test
