#include <mien/scene.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

struct Lens {
  Scene scene;
  Area both, minus, ring;
};

Lens lens() {
  SceneBuilder build({.box = {{-2, -1}, {2, 1}}}, {1, 1, 1, 1});
  const Area left = build.shape(Disc{{-0.5, 0}, 1}), right = build.shape(Disc{{0.5, 0}, 1});
  const Area both = build.intersect(left, right), minus = build.subtract(left, right);
  const Area ring = build.shell(build.offset(both, 0.25), 0.125);
  build.layer("lens", both, {{0.5, 0.25, 0, 1}});
  build.layer("ring", ring, {{0, 0, 0, 0.5}});
  return {std::move(build).finish(), both, minus, ring};
}

TEST(Scene, DistancesFollowTheTree) {
  const Lens l = lens();
  EXPECT_DOUBLE_EQ(l.scene.distance(l.both, {0, 0}), -0.5);
  EXPECT_DOUBLE_EQ(l.scene.distance(l.minus, {-1, 0}), -0.5);
  EXPECT_DOUBLE_EQ(l.scene.distance(l.ring, {0, 0}), 0.75 - 0.125);
}

TEST(Scene, SaysWhatIsExactAndWhatABound) {
  const Lens l = lens();
  EXPECT_EQ(l.scene.exactness(l.both), (Exactness{false, true}));
  EXPECT_EQ(l.scene.exactness(l.ring), (Exactness{false, false}));
}

TEST(Scene, BoundsContainTheInside) {
  const Lens l = lens();
  for (const Area area : {l.both, l.minus, l.ring}) {
    const Box2 box = l.scene.bounds(area);
    for (double y = -2; y <= 2; y += 0.02)
      for (double x = -2; x <= 2; x += 0.02)
        EXPECT_TRUE(l.scene.distance(area, {x, y}) > 0 || grown(box, 1e-12).contains({x, y}));
  }
  EXPECT_NEAR(l.scene.bounds(l.both).lo.x, -0.5, 1e-12);
}

TEST(Scene, PrintsAsText) {
  EXPECT_EQ(lens().scene.text(), R"(canvas -2,-1 2,1 y up
background 1 1 1 1
a0 = disc center -0.5,0 radius 1
a1 = disc center 0.5,0 radius 1
a2 = intersect a0 a1
a3 = subtract a0 a1
a4 = offset a2 0.25
a5 = shell a4 0.125
layer lens area a2 color 0.5 0.25 0 1 (bound outside, exact inside)
layer ring area a5 color 0 0 0 0.5 (bound outside, bound inside)
)");
}

TEST(Scene, PrintsHowGroupsMix) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.open_group("plain", 1);
  build.open_group("glass", 0.5, {}, MixMode::multiply);
  build.layer("lens", build.shape(Disc{{0, 0}, 0.5}), {{1, 0, 0, 1}});
  const std::string text = std::move(build).finish().text();
  EXPECT_NE(text.find("group g0 plain opacity 1\ngroup g1 glass opacity 0.5 mix multiply in g0\n"),
            std::string::npos)
      << text;
}

TEST(Scene, AChainOfAHundredThousandIsNoDeepRecursion) {
  SceneBuilder build({}, {});
  Area all = build.shape(Disc{{0, 0}, 0.1});
  for (int i = 1; i < 100'000; ++i) all = build.unite(build.shape(Disc{{double(i), 0}, 0.1}), all);
  build.layer("beads", all, {});
  const Scene scene = std::move(build).finish();
  EXPECT_NEAR(scene.distance(all, {70000.5, 0}), 0.4, 1e-12);
}

}  // namespace
}  // namespace mien
