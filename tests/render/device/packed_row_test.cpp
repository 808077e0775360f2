#include "render/device/packed_row.h"

#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace mien {
namespace {

using Level16 = std::uint16_t;

std::vector<std::byte> row_of(Level16 r, Level16 g, Level16 b, Level16 a, int width) {
  std::vector<std::byte> row(8 * std::size_t(width));
  const Level16 rgba[4] = {r, g, b, a};
  for (int i = 0; i < width; ++i) std::memcpy(row.data() + 8 * i, rgba, 8);
  return row;
}

std::vector<std::byte> row_of(float r, float g, float b, int width) {
  std::vector<std::byte> row(16 * std::size_t(width));
  const float rgba[4] = {r, g, b, 1};
  for (int i = 0; i < width; ++i) std::memcpy(row.data() + 16 * i, rgba, 16);
  return row;
}

struct Levels {
  double r = 0, g = 0, b = 0;
};

/// The mean over 8 x 8 pixels of one colour.
Levels mean_565(const std::vector<std::byte>& row, bool dither, int x = 0) {
  Levels mean;
  for (int y = 3; y < 11; ++y) {
    std::vector<Level16> to(8);
    pack_row(DeviceFormat::rgb565, row.data(), x, y, 8, dither,
             reinterpret_cast<std::byte*>(to.data()));
    for (const Level16 bits : to)
      mean.r += (bits >> 11) / 64.0, mean.g += (bits >> 5 & 63) / 64.0,
          mean.b += (bits & 31) / 64.0;
  }
  return mean;
}

TEST(PackedRow, MeansOf565AreRight) {
  for (int v = 0; v <= 65535; v += 241) {
    const auto level = Level16(v);
    const Levels mean = mean_565(row_of(level, level, level, 65535, 8), true, v % 8);
    EXPECT_NEAR(mean.r, v / 65535.0 * 31, 1 / 128.0 + 1e-9) << v;
    EXPECT_NEAR(mean.g, v / 65535.0 * 63, 1 / 128.0 + 1e-9) << v;
    EXPECT_NEAR(mean.b, v / 65535.0 * 31, 1 / 128.0 + 1e-9) << v;
  }
}

TEST(PackedRow, WholeLevelsOf565Stay) {
  for (int v = 0; v <= 31; ++v) {
    const auto level = Level16(std::lround(v / 31.0 * 65535));
    for (const bool dither : {false, true}) {
      const Levels mean = mean_565(row_of(level, 0, 65535, 65535, 8), dither);
      EXPECT_NEAR(mean.r, v, 1 / 64.0);
      EXPECT_EQ(mean.g, 0);
      EXPECT_EQ(mean.b, 31);
    }
  }
}

TEST(PackedRow, WithoutDitherLevelsAreTheNearest) {
  for (int v = 0; v <= 65535; v += 97) {
    const Levels mean = mean_565(row_of(Level16(v), Level16(v), 0, 65535, 8), false);
    EXPECT_EQ(mean.r, std::floor(v / 65535.0 * 31 + 0.5));
    EXPECT_EQ(mean.g, std::floor(v / 65535.0 * 63 + 0.5));
  }
}

TEST(PackedRow, WhatIsOpenIsBlack) {
  const Levels half = mean_565(row_of(65535, 65535, 65535, 32768, 8), true);
  EXPECT_NEAR(half.r, 15.5, 0.02);
  EXPECT_NEAR(half.g, 31.5, 0.02);
  EXPECT_EQ(mean_565(row_of(65535, 65535, 65535, 0, 8), true).r, 0);
  const std::byte white[4] = {std::byte{255}, std::byte{255}, std::byte{100}, std::byte{51}};
  std::byte out[4];
  pack_row(DeviceFormat::bgrx, white, 0, 0, 1, true, out);
  EXPECT_EQ(std::to_integer<int>(out[0]), 20);
  EXPECT_EQ(std::to_integer<int>(out[1]), 51);
  EXPECT_EQ(std::to_integer<int>(out[2]), 51);
  EXPECT_EQ(std::to_integer<int>(out[3]), 255);
}

TEST(PackedRow, SwappedIsSwapped) {
  const std::vector<std::byte> row = row_of(60000, 20000, 5000, 65535, 8);
  Level16 plain[8], swapped[8];
  pack_row(DeviceFormat::rgb565, row.data(), 5, 9, 8, true, reinterpret_cast<std::byte*>(plain));
  pack_row(DeviceFormat::rgb565_swapped, row.data(), 5, 9, 8, true,
           reinterpret_cast<std::byte*>(swapped));
  for (int i = 0; i < 8; ++i) EXPECT_EQ(swapped[i], Level16(plain[i] << 8 | plain[i] >> 8));
}

TEST(PackedRow, WhiteInMonoIsAsMuchAsThereIsLight) {
  for (int v = 0; v <= 200; ++v) {
    const float light = float(v) / 200;
    int white = 0;
    for (int y = 0; y < 8; ++y) {
      std::byte bits{0xff};
      pack_row(DeviceFormat::mono, row_of(light, light, light, 8).data(), 16, y, 8, true, &bits);
      white += std::popcount(std::to_integer<unsigned>(bits));
    }
    EXPECT_NEAR(white / 64.0, double(light), 1 / 128.0 + 1e-6) << v;
  }
  int green = 0;
  for (int y = 0; y < 8; ++y) {
    std::byte bits{};
    pack_row(DeviceFormat::mono, row_of(0, 1, 0, 8).data(), 0, y, 8, true, &bits);
    green += std::popcount(std::to_integer<unsigned>(bits));
  }
  EXPECT_NEAR(green / 64.0, 0.7152, 1 / 128.0);
}

TEST(PackedRow, MonoBeginsAtTheUppermostBit) {
  std::vector<std::byte> row = row_of(0, 0, 0, 11);
  const std::vector<std::byte> white = row_of(1, 1, 1, 1);
  for (const int x : {0, 6, 9}) std::memcpy(row.data() + 16 * x, white.data(), 16);
  std::byte bits[3] = {std::byte{0xee}, std::byte{0xee}, std::byte{0xee}};
  pack_row(DeviceFormat::mono, row.data(), 0, 0, 11, true, bits);
  EXPECT_EQ(std::to_integer<int>(bits[0]), 0b10000010);
  EXPECT_EQ(std::to_integer<int>(bits[1]), 0b01000000);
  EXPECT_EQ(std::to_integer<int>(bits[2]), 0xee);
  const auto grey = float(linear_from_srgb(0.5));
  pack_row(DeviceFormat::mono, row_of(grey * 1.01f, grey * 1.01f, grey * 1.01f, 1).data(), 0, 0, 1,
           false, bits);
  EXPECT_EQ(std::to_integer<int>(bits[0]), 0x80);
  pack_row(DeviceFormat::mono, row_of(grey * 0.99f, grey * 0.99f, grey * 0.99f, 1).data(), 0, 0, 1,
           false, bits);
  EXPECT_EQ(std::to_integer<int>(bits[0]), 0);
}

}  // namespace
}  // namespace mien
