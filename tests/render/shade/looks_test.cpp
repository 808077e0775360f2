#include "render/shade/looks.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

constexpr View kLooksView{.width = 100, .height = 100, .blend = Blend::srgb};

struct Table {
  PaintTable paints;
  Looks looks;
  Regions regions;

  explicit Table(SceneBuilder&& build) {
    paints.make(std::move(build).finish(), kLooksView, Depth::u8);
    looks.begin(paints);
    regions.begin(int(paints.programs.outlines().size()), looks);
  }
  /// The look inside of these outlines.
  int look(std::initializer_list<int> inside) {
    int region = 0;
    for (const int outline : inside) region = regions.across(region, outline);
    return regions.look(region);
  }
  Mix mix(std::initializer_list<int> inside) { return looks.mix(look(inside)); }
};

SceneBuilder builder() {
  return SceneBuilder({.box = {{0, 0}, {1, 1}}}, {1, 1, 1, 1});
}

TEST(Looks, LayWhatIsTranslucentOverWhatIsBelow) {
  SceneBuilder build = builder();
  build.layer("red", build.shape(Disc{{0.4, 0.5}, 0.3}), {{1, 0, 0, 1}});
  build.layer("shade", build.shape(Disc{{0.6, 0.5}, 0.3}), {{0, 0, 0, 0.25}});
  Table t(std::move(build));
  EXPECT_EQ(t.mix({}), (Mix{1, 1, 1, 1}));
  EXPECT_EQ(t.mix({0}), (Mix{1, 0, 0, 1}));
  EXPECT_EQ(t.mix({1}), (Mix{0.75, 0.75, 0.75, 1}));
  EXPECT_EQ(t.mix({0, 1}), (Mix{0.75, 0, 0, 1}));
  EXPECT_EQ(t.look({1, 0}), t.look({0, 1}));
}

TEST(Looks, AreOneWhereNothingOfTheDifferenceIsSeen) {
  SceneBuilder build = builder();
  build.layer("below", build.shape(Disc{{0.4, 0.5}, 0.3}), {{1, 0, 0, 1}});
  build.layer("cover", build.shape(Disc{{0.5, 0.5}, 0.4}), {{0, 0, 1, 1}});
  Table t(std::move(build));
  EXPECT_EQ(t.look({0, 1}), t.look({1}));
  EXPECT_NE(t.look({0}), t.look({}));
}

TEST(Looks, MixGroupsFirst) {
  SceneBuilder build = builder();
  build.open_group("outer", 0.5);
  build.layer("black", build.shape(Disc{{0.4, 0.5}, 0.3}), {{0, 0, 0, 1}});
  build.open_group("inner", 0.5);
  build.layer("white", build.shape(Disc{{0.6, 0.5}, 0.3}), {{1, 1, 1, 1}});
  build.close_group();
  build.close_group();
  Table t(std::move(build));
  EXPECT_EQ(t.mix({0}), (Mix{0.5, 0.5, 0.5, 1}));
  EXPECT_EQ(t.mix({0, 1}), (Mix{0.75, 0.75, 0.75, 1}));  // half white over black, half of that
}

TEST(Looks, MixGroupsByTheirModeWithAllThatLiesBelow) {
  SceneBuilder build = builder();
  build.layer("gray", build.shape(Disc{{0.4, 0.5}, 0.3}), {{0.25, 0.25, 0.25, 1}});
  build.open_group("glass", 1, {}, MixMode::multiply);
  build.layer("lens", build.shape(Disc{{0.6, 0.5}, 0.3}), {{1, 0, 0, 1}});
  build.close_group();
  Table t(std::move(build));
  const double gray = t.mix({0}).r;
  EXPECT_EQ(t.mix({1}), (Mix{1, 0, 0, 1}));
  EXPECT_EQ(t.mix({0, 1}), (Mix{gray, 0, 0, 1}));  // an opaque lens hides nothing
}

TEST(Looks, MixAGroupInAGroupWithThatGroupAlone) {
  SceneBuilder build = builder();
  build.layer("gray", build.shape(Disc{{0.5, 0.5}, 0.4}), {{0.25, 0.25, 0.25, 1}});
  build.open_group("ground", 1);
  build.open_group("glass", 1, {}, MixMode::multiply);
  build.layer("lens", build.shape(Disc{{0.5, 0.5}, 0.3}), {{1, 0, 0, 1}});
  build.close_group();
  build.close_group();
  Table t(std::move(build));
  EXPECT_EQ(t.mix({0, 1}), (Mix{1, 0, 0, 1}));  // below the lens its group has nothing
}

/// Means by cells are then compared with those by larger ones.
TEST(Looks, KnowLightUnderWhatFadesOrMixes) {
  Relief relief{.area = {0}, .profile = Profile::bevel, .width = 0.1, .height = 0.05};
  const auto gradient = [](double alpha) {
    return shared(
        Gradient{LinearGradient{{0, 0}, {1, 0}}, {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, alpha}}}});
  };
  const auto is_product = [&](bool lit, double alpha, MixMode mode) {
    SceneBuilder build = builder();
    const Area disc = build.shape(Disc{{0.5, 0.5}, 0.4});
    build.layer("below", disc, {{0.5, 0.5, 0.5, 1}, {}, lit ? shared(relief) : nullptr});
    build.open_group("group", 1, {}, mode);
    build.layer("over", build.shape(Disc{{0.5, 0.5}, 0.3}),
                {.color = {1, 1, 1, 1}, .gradient = gradient(alpha)});
    build.close_group();
    Table t(std::move(build));
    bool products = false;
    for (int region = 0, outline = 0; outline < int(t.paints.programs.outlines().size());
         ++outline) {
      region = t.regions.across(region, outline);
      products = products || t.looks.products(t.regions.look(region));
    }
    return products;
  };
  EXPECT_TRUE(is_product(true, 0.2, MixMode::normal));
  EXPECT_TRUE(is_product(true, 1.0, MixMode::multiply));
  EXPECT_FALSE(is_product(true, 1.0, MixMode::normal));
  EXPECT_FALSE(is_product(false, 0.2, MixMode::normal));
}

TEST(Looks, ChangeAtTheStopsOfAGradient) {
  SceneBuilder build = builder();
  build.layer("ramp", build.everywhere(),
              {.color = {0, 0, 0, 1},
               .gradient = shared(Gradient{LinearGradient{{0.25, 0}, {0.75, 0}},
                                           {{0, {0, 0, 0, 1}}, {1, {1, 1, 1, 1}}}})});
  Table t(std::move(build));
  ASSERT_EQ(t.paints.programs.outlines().size(), 3u);  // everywhere, and one per stop
  EXPECT_TRUE(t.looks.constant(t.look({})));           // beyond the last
  EXPECT_NEAR(t.mix({}).r, 1, 1e-12);
  EXPECT_FALSE(t.looks.constant(t.look({2})));  // between them
  EXPECT_NEAR(t.mix({1, 2}).r, 0, 1e-12);       // before the first
}

}  // namespace
}  // namespace mien
