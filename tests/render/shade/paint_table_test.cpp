#include "render/shade/paint_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mien {
namespace {

constexpr View kTableView{.width = 200, .height = 100};

const VariedPaint& varied_of(PaintTable& table, const Paint& paint) {
  SceneBuilder build({.box = {{0, 0}, {2, 1}}}, {1, 1, 1, 1});
  build.shape(Disc{{1, 0.5}, 0.3});  // area 0
  build.layer("layer", build.everywhere(), paint);
  table.make(std::move(build).finish(), kTableView, Depth::u8);
  return table.varied.at(0);
}

TEST(PaintTable, CountsFromThePicturesCorner) {
  const auto map = grid_from_face({.box = {{0, 0}, {2, 1}}, .y_up = true}, kTableView);
  EXPECT_EQ(map(glm::dvec2(0, 1)), glm::dvec2(0, 0));
  EXPECT_EQ(map(glm::dvec2(2, 0)), glm::dvec2(200, 100));
}

TEST(PaintTable, MakesAnOutlineOfEveryStopThatThePictureShows) {
  PaintTable table;
  const Gradient gradient{
      RadialGradient{{1, 0.5}, {0.2, 0.1}}, {{0, {}}, {1, {1, 1, 1, 1}}}, Extend::repeat};
  const VariedPaint& paint =
      varied_of(table, {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  EXPECT_FALSE(paint.by_integral);
  EXPECT_EQ(paint.kinks.size(), 7u);  // the corner lies at t = 7.07; t = 0 has no outline
}

TEST(PaintTable, IntegratesRampsOfMoreStopsThanOutlinesAreMadeOf) {
  PaintTable table;
  const std::vector<Stop> stops{{0, {}}, {1, {1, 1, 1, 1}}};
  const Gradient across{LinearGradient{{0, 0}, {0.05, 0}}, stops, Extend::repeat},
      around{RadialGradient{{1, 0.5}, {0.02, 0.01}}, stops, Extend::reflect};
  for (const Gradient& gradient : {across, around}) {
    const VariedPaint& paint =
        varied_of(table, {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
    EXPECT_TRUE(paint.by_integral);
    EXPECT_TRUE(paint.kinks.empty());
  }
}

/// The one colour of a gradient that has no other.
Mix one_color(const Gradient& gradient) {
  SceneBuilder build({.box = {{0, 0}, {2, 1}}}, {1, 1, 1, 1});
  build.shape(Disc{{1, 0.5}, 0.3});
  build.layer("layer", build.everywhere(), {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  PaintTable table;
  View view = kTableView;
  view.blend = Blend::srgb;
  table.make(std::move(build).finish(), view, Depth::u8);
  EXPECT_TRUE(table.varied.empty());
  EXPECT_EQ(table.layers.at(0).varied, -1);
  return table.layers.at(0).mix;
}

TEST(PaintTable, GivesGradientsWithoutExtentTheirLastColour) {  // as SVG does
  const std::vector<Stop> stops{{0.2, {1, 0, 0, 1}}, {0.8, {0, 0, 1, 1}}};
  for (const Extend extend : {Extend::pad, Extend::repeat, Extend::reflect}) {
    EXPECT_EQ(one_color({LinearGradient{{1, 1}, {1, 1}}, stops, extend}), (Mix{0, 0, 1, 1}));
    EXPECT_EQ(one_color({RadialGradient{{1, 1}, {0, 1}}, stops, extend}), (Mix{0, 0, 1, 1}));
    EXPECT_EQ(one_color({RadialGradient{{1, 1}, {1, 0}}, stops, extend}), (Mix{0, 0, 1, 1}));
  }
}

TEST(PaintTable, GivesPeriodsThatNoPixelResolvesTheirMean) {
  const std::vector<Stop> stops{
      {0, {0, 0, 0, 1}}, {0.25, {0, 0, 0, 1}}, {0.25, {1, 1, 1, 1}}, {1, {1, 1, 1, 1}}};
  for (const double length : {1e-12, 1e-9, 1e-300}) {
    const Mix line = one_color({LinearGradient{{1, 1}, {1 + std::max(length, 1e-15), 1}}, stops,
                                Extend::repeat}),
              center =
                  one_color({RadialGradient{{1, 1}, {length, length}}, stops, Extend::reflect}),
              distance = one_color({DistanceGradient{Area{0}, 0, length}, stops, Extend::repeat});
    for (const Mix& mix : {line, center, distance}) EXPECT_NEAR(mix.r, 0.75, 1e-12);
  }
}

TEST(PaintTable, MakesOutlinesOfAReliefsStepsAndDomes) {
  PaintTable table;
  const Relief relief{.area = {0},
                      .profile = Profile::custom,
                      .width = 0.1,
                      .height = 0.1,
                      .table = {0, 1, 0.5},
                      .domes = {{.center = {1, 0.5}, .radii = {0.1, 0.1}, .height = 0.1},
                                {.center = {1, 0.5}, .radii = {0.1, 0.1}, .height = 0}}};
  const VariedPaint& paint = varied_of(table, {.color = {1, 1, 1, 1}, .relief = shared(relief)});
  EXPECT_EQ(paint.levels.size(), 3u);  // the outline, the step, the end
  EXPECT_EQ(paint.domes.size(), 1u);   // the other has no height
}

}  // namespace
}  // namespace mien
