// Text as paths; shown as ASCII, so that a reader sees whether it reads.

#include <mien/text_path.h>

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

/// The path on a grid of points one apart, rows from the top, y up.
std::string picture(const Path& path, int width, int height) {
  std::string text = "\n";
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) text += distance(path, {x + 0.5, y + 0.5}) < 0 ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(TextPath, Reads) {
  EXPECT_EQ(picture(text_path("Hi!", 16, {0, 1}), 24, 14), R"(
........................
..#......#....#....#....
..#......#....#....#....
..#......#.........#....
..#......#....#....#....
..#......#....#....#....
..########....#....#....
..#......#....#....#....
..#......#....#....#....
..#......#....#.........
..#......#....#.........
..#......#....#....#....
..#......#....#....#....
........................
)");
}

TEST(TextPath, IsMirroredWhereYPointsDown) {
  const Path up = text_path("R", 10, {0, 0}), down = text_path("R", 10, {0, 0}, {.y_up = false});
  for (double y = -2.5; y < 9; ++y) {
    for (double x = 0.5; x < 9; ++x) EXPECT_EQ(distance(up, {x, y}), distance(down, {x, -y}));
  }
}

TEST(TextPath, AnchorsPutTheLineWhereItIsWanted) {
  const double length = text_length("AVAV");
  EXPECT_LT(length, 2 * (text_length("A") + text_length("V"))) << "kerning";
  const auto left = [](TextAnchor anchor) {
    return bounds(Shape(text_path("AVAV", 10, {3, 0}, {.anchor = anchor}))).lo.x;
  };
  EXPECT_NEAR(left(TextAnchor::start) - left(TextAnchor::middle), 5 * length, 1e-9);
  EXPECT_NEAR(left(TextAnchor::start) - left(TextAnchor::end), 10 * length, 1e-9);
}

TEST(TextPath, TakesAnyBytes) {
  const auto loops = [](std::string_view text) { return text_path(text, 1, {0, 0}).loops.size(); };
  EXPECT_EQ(loops(""), 0u);
  EXPECT_EQ(loops(" \n\t\x7f"), 0u);
  EXPECT_EQ(text_length("a\nb"), text_length("ab"));
  EXPECT_EQ(text_length("\xff"), text_length("\xef\xbf\xbd")) << "U+FFFD";
  EXPECT_EQ(text_length("\xc3"), text_length("\xff"));
  EXPECT_EQ(text_length("\xed\xa0\x80"), 3 * text_length("\xff")) << "half a pair";
  EXPECT_EQ(text_length("\xe0\x80\xaf"), 3 * text_length("\xff")) << "overlong";
  EXPECT_EQ(loops("é"), loops("e") + 1);
}

TEST(TextArea, IsAShapeOfTheScene) {
  SceneBuilder build({{{0, 0}, {20, 10}}, true}, {1, 1, 1, 1});
  const Area area = text_area(build, "l", 10, {5, 1});
  build.layer("label", area, {});
  const Scene scene = std::move(build).finish();
  ASSERT_EQ(scene.shapes().size(), 1u);
  EXPECT_LT(scene.distance(area, {6.4, 4}), 0);
  EXPECT_GT(scene.distance(area, {9, 4}), 0);
}

}  // namespace
}  // namespace mien
