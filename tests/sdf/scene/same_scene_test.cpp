#include "sdf/scene/same_scene.h"

#include <gtest/gtest.h>

#include <functional>

namespace mien {
namespace {

/// Everything that a scene is made of, to be changed one by one.
struct Numbers {
  Canvas canvas{{{0, 0}, {10, 10}}, false};
  Color ground{1, 1, 1, 1};
  Disc disc{{5, 5}, 3};
  Line line{{1, 1}, {9, 9}, 0.5};
  double grown = 0.25, opacity = 0.5;
  MixMode mix = MixMode::multiply;
  Gradient gradient{RadialGradient{{5, 5}, {2, 2}}, {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 1}}}};
  double from = -1;
  Relief relief{.profile = Profile::round, .width = 1, .height = 0.5};
  Light light;

  Scene scene(const char* name = "a layer") const {
    SceneBuilder build(canvas, ground);
    build.light(light);
    const Area round = build.shape(disc), across = build.shape(line);
    build.open_group(name, opacity, {}, mix);
    build.layer(name, build.offset(round, grown), {{1, 0, 0, 1}, shared(Gradient(gradient))});
    build.close_group();
    Relief lit = relief;
    lit.area = across;
    build.layer(name, build.intersect(across, round), {{0, 1, 0, 1}, {}, shared(std::move(lit))});
    const Gradient along{DistanceGradient{round, from, 0}, gradient.stops};
    build.layer(name, across, {{0, 0, 1, 0.5}, shared(Gradient(along))});
    return std::move(build).finish();
  }
};

const std::vector<std::function<void(Numbers&)>> kChanges{
    [](Numbers& n) { n.canvas.box.hi.x = 11; },
    [](Numbers& n) { n.canvas.y_up = true; },
    [](Numbers& n) { n.ground.b = 0.5; },
    [](Numbers& n) { n.disc.radius = 3.5; },
    [](Numbers& n) { n.line.b.y = 8; },
    [](Numbers& n) { n.grown = 0.5; },
    [](Numbers& n) { n.opacity = 0.75; },
    [](Numbers& n) { n.gradient.stops[1].color.g = 1; },
    [](Numbers& n) { n.gradient.extend = Extend::repeat; },
    [](Numbers& n) {
      n.gradient.along = LinearGradient{{5, 5}, {2, 2}};
    },
    [](Numbers& n) { n.from = -2; },
    [](Numbers& n) { n.relief.height = 0.25; },
    [](Numbers& n) {
      n.relief.domes.push_back({{5, 5}, {1, 1}, {1, 0}, 1});
    },
    [](Numbers& n) { n.light.ambient = 0.5; },
    [](Numbers& n) { n.mix = MixMode::screen; },
};

TEST(SameScene, IsNumberForNumberAndNamesDoNotCount) {
  EXPECT_TRUE(same_scene(Numbers().scene(), Numbers().scene("another name")));
  for (std::size_t i = 0; i < kChanges.size(); ++i) {
    Numbers changed;
    kChanges[i](changed);
    EXPECT_FALSE(same_scene(Numbers().scene(), changed.scene())) << i;
  }
}

/// Which layers change: those whose paint or an area that it reads does, not those whose own area moves.
TEST(InCommon, KnowsWhichLayersReadWhatChanged) {
  const std::pair<std::size_t, std::vector<std::size_t>> cases[] = {
      {3, {2}}, {4, {1}},  {5, {}},   {7, {0, 2}}, {8, {0}},
      {9, {0}}, {10, {2}}, {11, {1}}, {12, {1}}};
  const Scene scene = Numbers().scene();
  for (const auto& [change, layers] : cases) {
    Numbers changed;
    kChanges[change](changed);
    const Scene other = changed.scene();
    InCommon common;
    ASSERT_TRUE(common.find(scene, other));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(!common.layer(i), std::count(layers.begin(), layers.end(), i) > 0)
          << change << ' ' << i;
  }
  for (const std::size_t change : {0, 1, 2, 6, 13, 14}) {
    Numbers changed;
    kChanges[change](changed);
    EXPECT_FALSE(InCommon().find(scene, changed.scene())) << change;
  }
  EXPECT_FALSE(InCommon().find(scene, Scene()));
}

}  // namespace
}  // namespace mien
