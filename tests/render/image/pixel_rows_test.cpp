#include "render/image/pixel_rows.h"
#include "render/blend/transfer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/support/pictures/sample_image.h"

namespace mien {
namespace {

/// A one-row image out of channels.
template <class Channel>
Image image_of(Depth depth, const std::vector<Channel>& channels) {
  Image image{int(channels.size() / 4), 1, depth, false, {}};
  image.bytes.resize(channels.size() * sizeof(Channel));
  std::memcpy(image.bytes.data(), channels.data(), image.bytes.size());
  return image;
}

template <class Channel>
std::vector<Channel> row_of(const Image& image, Depth wanted) {
  std::vector<Channel> row(std::size_t(image.width) * 4);
  PixelRows(image.depth, wanted).convert(image.row(0), row.data(), std::size_t(image.width));
  return row;
}

TEST(PixelRows, TheSameDepthStaysWhatItIs) {
  const Image image = test::sample_image(5, 1, Depth::u16, false);
  std::vector<std::byte> same(image.bytes.size());
  PixelRows(Depth::u16, Depth::u16).convert(image.bytes.data(), same.data(), 5);
  EXPECT_EQ(same, image.bytes);
}

TEST(PixelRows, LevelsBecomePremultipliedLight) {
  const Image image = image_of<std::uint8_t>(Depth::u8, {188, 0, 255, 255, 255, 188, 1, 51});
  const auto light = row_of<float>(image, Depth::f32);
  EXPECT_NEAR(light[0], linear_from_srgb(188 / 255.0), 1e-6);
  EXPECT_EQ(light[1], 0.0f);
  EXPECT_EQ(light[2], 1.0f);
  EXPECT_EQ(light[3], 1.0f);
  EXPECT_NEAR(light[4], 0.2, 1e-6);
  EXPECT_NEAR(light[5], 0.2 * linear_from_srgb(188 / 255.0), 1e-6);
  EXPECT_NEAR(light[7], 0.2, 1e-6);
}

TEST(PixelRows, LightBecomesStraightLevels) {
  const Image image =
      image_of<float>(Depth::f32, {0.1f, 0.2f, 0.0f, 0.2f, 0.1f, 0.2f, 0.0f, 0.2f,  //
                                   0.0f, 0.0f, 0.0f, 0.0f, 7.0f, -1.0f, NAN, 1.0f});
  const auto levels = row_of<std::uint16_t>(image, Depth::u16);
  const int half = int(std::lround(srgb_from_linear(0.5) * 65535));
  for (int repeated : {0, 4}) {
    EXPECT_EQ(levels[std::size_t(repeated)], half);
    EXPECT_EQ(levels[std::size_t(repeated) + 1], 65535);
    EXPECT_EQ(levels[std::size_t(repeated) + 3], 13107);
  }
  for (std::size_t i = 8; i < 12; ++i) EXPECT_EQ(levels[i], 0) << "no alpha, no colour";
  EXPECT_EQ(levels[12], 65535);
  EXPECT_EQ(levels[13], 0);
  EXPECT_EQ(levels[14], 0);
}

TEST(PixelRows, EveryLevelComesBackThroughLight) {
  for (Depth depth : {Depth::u8, Depth::u16}) {
    const int top = depth == Depth::u8 ? 255 : 65535;
    Image there{(top + 1), 1, depth, true, {}};
    there.bytes.resize(there.stride());
    for (int v = 0; v <= top; ++v) {
      for (int c = 0; c < 4; ++c) {
        const int value = c == 3 ? top : v;
        if (depth == Depth::u8)
          reinterpret_cast<std::uint8_t*>(there.bytes.data())[4 * v + c] = std::uint8_t(value);
        else
          reinterpret_cast<std::uint16_t*>(there.bytes.data())[4 * v + c] = std::uint16_t(value);
      }
    }
    const auto pixels = std::size_t(there.width);
    std::vector<float> light(pixels * 4);
    PixelRows(depth, Depth::f32).convert(there.bytes.data(), light.data(), pixels);
    std::vector<std::byte> back(there.bytes.size());
    PixelRows(Depth::f32, depth).convert(light.data(), back.data(), pixels);
    EXPECT_EQ(back, there.bytes);
  }
}

TEST(PixelRows, EightAndSixteenBitsMapExactly) {
  const Image narrow = image_of<std::uint8_t>(Depth::u8, {0, 1, 254, 255});
  EXPECT_EQ(row_of<std::uint16_t>(narrow, Depth::u16),
            (std::vector<std::uint16_t>{0, 257, 65278, 65535}));
  const Image wide = image_of<std::uint16_t>(Depth::u16, {128, 129, 65406, 65407});
  EXPECT_EQ(row_of<std::uint8_t>(wide, Depth::u8), (std::vector<std::uint8_t>{0, 1, 254, 255}));
}

}  // namespace
}  // namespace mien
