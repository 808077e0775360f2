#include "render/blend/blender.h"

#include <gtest/gtest.h>

#include <array>

namespace mien {
namespace {

std::array<int, 4> stored(const Color& color, Blend blend) {
  std::array<std::uint8_t, 4> pixel;
  store(mix_from_color(color, blend), blend, Depth::u8, pixel.data());
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

TEST(Store, GivesBackTheColourInEitherBlend) {
  const Color skin{0.9301108583754237, 0.7083757798916868, 0.33245153634617935,
                   1};  // 247, 219, 156
  for (const Blend blend : {Blend::linear, Blend::srgb})
    EXPECT_EQ(stored(skin, blend), (std::array<int, 4>{247, 219, 156, 255}));
}

TEST(Store, IsNotPremultipliedInWholeNumbersAndIsInLight) {
  const Color half{1, 0.5, 0, 0.5};
  EXPECT_EQ(stored(half, Blend::linear), (std::array<int, 4>{255, 188, 0, 128}));
  std::array<float, 4> light;
  store(mix_from_color(half, Blend::srgb), Blend::srgb, Depth::f32, light.data());
  EXPECT_FLOAT_EQ(light[1], 0.25f);
  EXPECT_FLOAT_EQ(light[3], 0.5f);
}

TEST(Store, OfNothingIsTransparentBlack) {
  EXPECT_EQ(stored({1, 1, 1, 0}, Blend::linear), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST(Over, MixesHalfBlackAndWhiteInTheBlendsOwnSpace) {
  for (const Blend blend : {Blend::linear, Blend::srgb}) {
    const Mix mix =
        0.5 * mix_from_color({0, 0, 0, 1}, blend) + 0.5 * mix_from_color({1, 1, 1, 1}, blend);
    std::array<std::uint8_t, 4> pixel;
    store(mix, blend, Depth::u8, pixel.data());
    EXPECT_EQ(pixel[0], blend == Blend::linear ? 188 : 128);
  }
  const Mix top = mix_from_color({1, 0, 0, 0.25}, Blend::linear),
            below = mix_from_color({0, 0, 1, 1}, Blend::linear);
  EXPECT_EQ(over(top, below), (Mix{0.25, 0, 0.75, 1}));
}

/// The W3C's formulas, of straight colours.
double blended_straight(MixMode mode, double cb, double ab, double cs, double as) {
  const double both = mode == MixMode::multiply ? cb * cs : cb + cs - cb * cs;
  return as * ((1 - ab) * cs + ab * both) + (1 - as) * ab * cb;
}

TEST(Blended, IsTheStandardsFormulaForAnyOpacities) {
  for (const double as : {0.0, 0.3, 1.0})
    for (const double ab : {0.0, 0.6, 1.0})
      for (const MixMode mode : {MixMode::multiply, MixMode::screen}) {
        const Mix top = as * Mix{0.9, 0.5, 0, 1}, below = ab * Mix{0.2, 0.7, 1, 1};
        const Mix mix = blended(mode, top, below);
        EXPECT_NEAR(mix.r, blended_straight(mode, 0.2, ab, 0.9, as), 1e-15);
        EXPECT_NEAR(mix.g, blended_straight(mode, 0.7, ab, 0.5, as), 1e-15);
        EXPECT_NEAR(mix.b, blended_straight(mode, 1, ab, 0, as), 1e-15);
        EXPECT_NEAR(mix.a, as + ab - as * ab, 1e-15);
        EXPECT_EQ(blended(MixMode::normal, top, below), over(top, below));
      }
}

TEST(StoreDithered, MovesAValueByLessThanALevelAndNotOnAverage) {  // E13
  for (const double value : {0.0, 17.0, 17.25, 200.9, 255.0}) {
    double sum = 0;
    for (int y = 8; y < 16; ++y)
      for (int x = 16; x < 24; ++x) {
        std::uint8_t pixel[4];
        store_dithered({value / 255, 0, 0, 1}, Blend::srgb, Depth::u8, x, y, pixel);
        EXPECT_LT(std::abs(pixel[0] - value), 1);
        EXPECT_EQ(pixel[3], 255);
        sum += pixel[0];
      }
    EXPECT_NEAR(sum / 64, value, 1.0 / 128 + 1e-9);
  }
}

}  // namespace
}  // namespace mien
