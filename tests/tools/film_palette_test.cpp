// Palettes of films, and the colours that are chosen for them.

#include "tools/mien/film/film_palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tools/mien/film/median_cut.h"

namespace mien::command {
namespace {

/// A picture in one row per channel value.
Image picture_of(int width, int height, auto&& draw) {
  Image image{width, height, Depth::u8, true, {}};
  image.bytes.resize(image.stride() * std::size_t(height), std::byte(255));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      draw(x, y,
           reinterpret_cast<std::uint8_t*>(image.bytes.data()) +
               4 * (std::size_t(y) * std::size_t(width) + std::size_t(x)));
  return image;
}

FilmPalette palette_of_picture(const Image& image) {
  FilmPalette palette;
  palette.count(image);
  palette.choose();
  return palette;
}

TEST(FilmPalette, HasEveryColourWhereThereAreFew) {
  const Image image = picture_of(255, 4, [](int x, int, std::uint8_t* p) {
    p[0] = std::uint8_t(x), p[1] = std::uint8_t(x * 7), p[2] = std::uint8_t(255 - x);
  });
  FilmPalette palette = palette_of_picture(image);
  EXPECT_EQ(palette.colors().size(), 255u);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 255; ++x) {
      const std::uint8_t* pixel = image.row(y) + 4 * x;
      const auto shown = palette.colors()[palette.place_of(pixel, x, y)];
      EXPECT_TRUE(shown.r == pixel[0] && shown.g == pixel[1] && shown.b == pixel[2]) << x;
    }
}

TEST(FilmPalette, ShowsNothingWhereNothingIs) {
  FilmPalette palette =
      palette_of_picture(picture_of(3, 3, [](int, int, std::uint8_t* p) { p[3] = 127; }));
  EXPECT_EQ(palette.colors().size(), 1u);
}

// A plane of many colours: means over 8 × 8 pixels are nearer to the colours than the nearest places are.
TEST(FilmPalette, MixesWhatLiesBetween) {
  const auto color = [](int x, int y, std::uint8_t* p) {
    p[0] = std::uint8_t(x / 8 * 4), p[1] = std::uint8_t(y / 8 * 4), p[2] = 128;
  };
  const Image image = picture_of(512, 512, color);
  FilmPalette palette = palette_of_picture(image);
  double mixed = 0, nearest = 0;
  for (int top = 0; top < 512; top += 8)
    for (int left = 0; left < 512; left += 8) {
      double sum[3] = {};
      for (int y = top; y < top + 8; ++y)
        for (int x = left; x < left + 8; ++x) {
          const auto shown = palette.colors()[palette.place_of(image.row(y) + 4 * x, x, y)];
          sum[0] += shown.r / 64.0, sum[1] += shown.g / 64.0, sum[2] += shown.b / 64.0;
        }
      const std::uint8_t* pixel = image.row(top) + 4 * left;
      double least = 1e9;
      for (const auto& c : palette.colors())
        least = std::min(least, std::hypot(c.r - pixel[0], c.g - pixel[1], c.b - pixel[2]));
      nearest += least;
      mixed += std::hypot(sum[0] - pixel[0], sum[1] - pixel[1], sum[2] - pixel[2]);
    }
  EXPECT_LT(mixed, 0.7 * nearest);
}

TEST(MedianCut, KeepsSmallFarColoursBesideLargeNearOnes) {
  std::vector<CountedColor> colors;
  for (int i = 0; i < 1000; ++i)
    colors.push_back({{0.7f + 1e-5f * float(i), 0, 0}, 1000, std::uint32_t(i)});
  colors.push_back({{0.5f, 0.2f, 0.1f}, 60, 5000});  // a tongue
  const auto chosen = chosen_colors(colors, 16);
  EXPECT_EQ(chosen.size(), 16u);
  std::set<std::uint32_t> packed;
  for (const CountedColor& color : chosen) packed.insert(color.packed);
  EXPECT_EQ(packed.count(5000), 1u);
  EXPECT_EQ(packed.size(), 16u);
}

}  // namespace
}  // namespace mien::command
