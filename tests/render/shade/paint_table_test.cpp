#include "render/shade/paint_table.h"

#include <gtest/gtest.h>

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
  EXPECT_FALSE(paint.dense);
  EXPECT_EQ(paint.kinks.size(), 7u);  // the corner lies at t = 7.07; t = 0 has no outline
}

TEST(PaintTable, KnowsStopsThatAreTooManyToBeOutlines) {
  PaintTable table;
  const Gradient gradient{
      LinearGradient{{0, 0}, {0.001, 0}}, {{0, {}}, {1, {1, 1, 1, 1}}}, Extend::repeat};
  const VariedPaint& paint =
      varied_of(table, {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  EXPECT_TRUE(paint.dense);
  EXPECT_TRUE(paint.kinks.empty());
  EXPECT_GE(paint.lit, 0);
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
