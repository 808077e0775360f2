#include <mien/error_map.h>

#include <mien/render.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/exact/exact_mix.h"
#include "tests/support/exact/exact_truth.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random_plain_scene.h"
#include "tests/support/random/random_scene.h"

namespace mien {
namespace {

Scene disc(double radius) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.layer("disc", build.shape(Disc{{0, 0}, radius}), {{0, 0, 0, 1}});
  return std::move(build).finish();
}

TEST(ErrorMap, IsZeroWhereNothingIsApproximated) {
  const ErrorMap map = error_map(disc(0.7), {.width = 40, .height = 40}).value();
  EXPECT_EQ(map.levels[0], 0);
  EXPECT_EQ(map.levels[20 * 40 + 20], 0);
  EXPECT_GT(map.worst, 0);
  EXPECT_EQ(map.worst, *std::max_element(map.levels.begin(), map.levels.end()));
}

TEST(ErrorMap, ProvesOutlinesToTwoThirdsOfALevelAndFinerAtSixteenBits) {
  const View view{.width = 300, .height = 300, .blend = Blend::srgb};
  const float eight = error_map(disc(0.7), view)->worst,
              sixteen = error_map(disc(0.7), view, {.depth = Depth::u16})->worst;
  EXPECT_LT(eight, 0.67f);
  EXPECT_LE(sixteen, eight);
  EXPECT_LT(sixteen, 0.5f * eight);
}

TEST(ErrorMap, IsTheSameInARegionAndAsGrey) {
  View view{.width = 60, .height = 50};
  const ErrorMap whole = error_map(disc(0.7), view).value();
  view.region = PixelRect{10, 5, 20, 30};
  const ErrorMap part = error_map(disc(0.7), view).value();
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

TEST(ErrorMap, TellsWhichPixelsLightTakesPartIn) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  const auto ball = build.shape(Disc{{0, 0}, 0.5});
  const Relief relief{.area = ball, .profile = Profile::round, .width = 0.4, .height = 0.4};
  build.layer("ball", ball, {.color = {0.2, 0.4, 0.6, 1}, .relief = shared(relief)});
  const Scene scene = std::move(build).finish();
  const ErrorMap map = error_map(scene, {.width = 40, .height = 40}).value();
  const double inside = 3.14159265 * 10 * 10, edge = 2 * 3.14159265 * 10;
  EXPECT_EQ(map.estimated[14 * 40 + 20], 1);
  EXPECT_EQ(map.estimated[2 * 40 + 2], 0);
  EXPECT_EQ(map.estimated[20 * 40 + 20], 0) << "level";
  EXPECT_GT(map.estimated_pixels(), inside - 20);
  EXPECT_LT(map.estimated_pixels(), inside + 1.5 * edge);
  const Image image = map.image();
  EXPECT_GE(image.row(14)[4 * 20 + 2], 128) << "half blue";
  EXPECT_EQ(image.row(2)[4 * 2 + 2], 0);
  EXPECT_EQ(error_map(disc(0.7), {.width = 40, .height = 40})->estimated_pixels(), 0);
}

// Its word: no pixel of the picture drawn is farther from the exact one than the map says. In floats, whose
// rounding hides nothing.

struct MapWord {
  long pixels = 0, broken = 0;
  double nearest = 0;  ///< the largest error in shares of its bound
  std::string where;
};

void keep_word(const Scene& scene, int side, int every, MapWord& word) {
  constexpr double kTruth = 3e-4;  // levels of 255
  const View view{.width = side, .height = side, .dither = false};
  const ErrorMap map = error_map(scene, view, {.depth = Depth::f32}).value();
  const Image image = test::rendered(scene, view, {.depth = Depth::f32});
  const test::ExactTruth truth(scene, view);
  for (int y = 0; y < side; ++y)
    for (int x = y % every; x < side; x += every) {
      if (map.estimated[std::size_t(side * y + x)]) continue;
      const glm::dvec4 exact = truth.pixel(x, y);
      const float* const drawn = reinterpret_cast<const float*>(image.row(y)) + 4 * x;
      double off = -kTruth;
      for (int k = 0; k < 3; ++k)
        off = std::max(off,
                       255 * std::abs(test::encoded(drawn[k]) - test::encoded(exact[k])) - kTruth);
      const double bound = map.levels[std::size_t(side * y + x)];
      ++word.pixels;
      if (bound > 0) word.nearest = std::max(word.nearest, off / bound);
      if (off <= bound) continue;
      ++word.broken;
      word.where = fmt::format("({}, {}) of {}: off {:.5f}, bound {:.5f}", x, y, side, off, bound);
    }
}

/// Along a large disc outlines are off as far as they may be, for pixels on end.
TEST(ErrorMap, KeepsItsWordOnADiscAndIsNotFarOff) {
  MapWord word;
  keep_word(disc(0.7), 300, 7, word);
  EXPECT_EQ(word.broken, 0) << word.where;
  EXPECT_GT(word.nearest, 0.5);
}

TEST(ErrorMap, KeepsItsWordOnRandomScenes) {
  MapWord word;
  for (int seed = 1; seed <= test::times(8); ++seed) {
    keep_word(test::random_plain_scene(std::uint64_t(seed)), 24, 5, word);
    keep_word(test::random_painted_scene(std::uint64_t(seed)), 8, 5, word);
  }
  EXPECT_EQ(word.broken, 0) << word.where;
  EXPECT_GT(word.pixels, test::times(900));
}

}  // namespace
}  // namespace mien
