#include <mien/error_map.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace mien {
namespace {

Scene disc(double radius) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.layer("disc", build.shape(Disc{{0, 0}, radius}), {{0, 0, 0, 1}});
  return std::move(build).finish();
}

TEST(ErrorMap, IsZeroWhereNothingIsApproximated) {
  const ErrorMap map = error_map(disc(0.7), {.width = 40, .height = 40});
  EXPECT_EQ(map.levels[0], 0);
  EXPECT_EQ(map.levels[20 * 40 + 20], 0);
  EXPECT_GT(map.worst, 0);
  EXPECT_EQ(map.worst, *std::max_element(map.levels.begin(), map.levels.end()));
}

TEST(ErrorMap, ProvesOutlinesToTwoThirdsOfALevelAndFinerAtSixteenBits) {
  const View view{.width = 300, .height = 300, .blend = Blend::srgb};
  const float eight = error_map(disc(0.7), view).worst,
              sixteen = error_map(disc(0.7), view, Depth::u16).worst;
  EXPECT_LT(eight, 0.67f);
  EXPECT_LE(sixteen, eight);
  EXPECT_LT(sixteen, 0.5f * eight);
}

TEST(ErrorMap, IsTheSameInARegionAndAsGrey) {
  View view{.width = 60, .height = 50};
  const ErrorMap whole = error_map(disc(0.7), view);
  view.region = PixelRect{10, 5, 20, 30};
  const ErrorMap part = error_map(disc(0.7), view);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 20; ++x)
      ASSERT_EQ(part.levels[std::size_t(20 * y + x)],
                whole.levels[std::size_t(60 * (y + 5) + x + 10)]);
  const Image image = whole.image();
  EXPECT_EQ(image.width, 60);
  const auto worst =
      std::max_element(whole.levels.begin(), whole.levels.end()) - whole.levels.begin();
  EXPECT_EQ(image.row(0)[4 * worst], 255);
}

}  // namespace
}  // namespace mien
