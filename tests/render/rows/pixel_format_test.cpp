#include "render/rows/pixel_format.h"
#include "render/blend/transfer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "tests/support/random/random.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::test {
namespace {

template <class Channel>
std::array<Channel, 4> put(const PixelFormat& format, const Mix& mix, double carry) {
  std::array<std::byte, 16> bytes{};  // as long as the longest pixel
  const std::vector<float> carries(1 + kColorSpare, float(carry));
  ColorRow row;
  row.room_for(1);
  const Rgba c = rgba_from_mix(mix);
  row.r[0] = c.r, row.g[0] = c.g, row.b[0] = c.b, row.a[0] = c.a;
  format.put(row.planes(), carries.data(), 1, bytes.data());
  std::array<Channel, 4> out;
  std::memcpy(out.data(), bytes.data(), sizeof out);
  return out;
}

template <class Channel>
std::array<Channel, 4> stored(const PixelFormat& format, const Mix& mix) {
  std::array<Channel, 4> out;
  store(mix, format.blend(), format.depth(), out.data());
  return out;
}

Mix random_mix(Random& r, bool opaque) {
  const double a = opaque ? 1.0 : r.chance(0.1) ? 0.0 : r.unit();
  const double dark = r.chance(0.3) ? 0.01 : 1.0;
  const double red = r.unit(), green = r.unit();
  return a * Mix{dark * red, dark * green, dark * r.unit(), 1.0};
}

template <class Channel>
void expect_twins(Depth depth, double allowed) {
  for (const Blend blend : {Blend::linear, Blend::srgb})
    for (const bool opaque : {true, false}) {
      const PixelFormat format(depth, blend);
      Random r(1);
      double worst = 0.0;
      for (int i = 0; i < 20'000; ++i) {
        const Mix mix = random_mix(r, opaque);
        const auto a = put<Channel>(format, mix, 0.5), b = stored<Channel>(format, mix);
        // What hardly covers has a colour that hardly counts.
        const double seen = std::min(1.0, mix.a * 64);
        for (std::size_t c = 0; c < 4; ++c)
          worst = std::max(worst, (c < 3 ? seen : 1.0) * std::abs(double(a[c]) - double(b[c])));
      }
      EXPECT_LE(worst, allowed) << int(blend) << opaque;
    }
}

TEST(PixelFormat, EightBitsAreThoseOfStoreButForRoundingUpOrDown) {
  on_every_set([] { expect_twins<std::uint8_t>(Depth::u8, 1.0); });
}

TEST(PixelFormat, SixteenBitsAreThoseOfStoreButForAFewLevels) {
  on_every_set([] { expect_twins<std::uint16_t>(Depth::u16, 2.0); });
}

TEST(PixelFormat, EightBitsAreThoseOfStoreWhereItIsNoCloseCall) {
  for (const Blend blend : {Blend::linear, Blend::srgb}) {
    const PixelFormat format(Depth::u8, blend);
    Random r(2);
    for (int i = 0; i < 20'000; ++i) {
      Mix mix{0.0, 0.0, 0.0, 1.0};
      double level[3];
      for (int c = 0; c < 3; ++c) {
        level[c] = r.below(255) + r.between(0.02, 0.98) - 0.5;
        const double v = std::max(level[c], 0.0) / 255;
        mix[c] = blend == Blend::linear ? linear_from_srgb(v) : v;
      }
      ASSERT_EQ(put<std::uint8_t>(format, mix, 0.5), stored<std::uint8_t>(format, mix)) << i;
    }
  }
}

TEST(PixelFormat, ADithersThresholdIsAdded) {
  for (const Depth depth : {Depth::u8, Depth::u16})
    for (const Blend blend : {Blend::linear, Blend::srgb}) {
      const PixelFormat format(depth, blend);
      Random r(3);
      for (int i = 0; i < 4000; ++i) {
        const Mix mix = random_mix(r, true);
        const int x = r.below(100), y = r.below(100);
        if (depth == Depth::u8) {
          std::array<std::uint8_t, 4> b;
          store_dithered(mix, blend, depth, x, y, b.data());
          const auto a = put<std::uint8_t>(format, mix, dither_threshold(x, y));
          for (std::size_t c = 0; c < 4; ++c) ASSERT_LE(std::abs(a[c] - b[c]), 1);
        } else {
          std::array<std::uint16_t, 4> b;
          store_dithered(mix, blend, depth, x, y, b.data());
          const auto a = put<std::uint16_t>(format, mix, dither_threshold(x, y));
          for (std::size_t c = 0; c < 4; ++c) ASSERT_LE(std::abs(a[c] - b[c]), 2);
        }
      }
    }
}

TEST(PixelFormat, FloatsAreThoseOfStore) {
  for (const Blend blend : {Blend::linear, Blend::srgb}) {
    const PixelFormat format(Depth::f32, blend);
    Random r(4);
    for (int i = 0; i < 4000; ++i) {
      const Mix mix = random_mix(r, r.chance(0.5));
      const auto a = put<float>(format, mix, 0.5), b = stored<float>(format, mix);
      for (std::size_t c = 0; c < 4; ++c) ASSERT_NEAR(a[c], b[c], 1e-6);
    }
  }
}

TEST(PixelFormat, OpaqueIsOpaqueInSpiteOfRoundings) {
  const PixelFormat format(Depth::u16, Blend::srgb);
  for (const double a : {1.0, 1.0 - 1e-7, 1.0 + 1e-6}) {
    const auto out = put<std::uint16_t>(format, Mix{0.5, 0.5, 0.5, a}, 0.0);
    EXPECT_EQ(out[3], 65535) << a;
  }
}

TEST(PixelFormat, NothingIsBlackAndClear) {
  for (const Blend blend : {Blend::linear, Blend::srgb}) {
    const PixelFormat format(Depth::u16, blend);
    const std::array<std::uint16_t, 4> nothing{};
    EXPECT_EQ(put<std::uint16_t>(format, {}, 0.5), nothing);
    const Mix roundings{-1e-7, 1e-8, -1e-7, -1e-7};
    EXPECT_EQ(put<std::uint16_t>(format, roundings, 0.5), nothing);
  }
}

TEST(PixelFormat, ManyAreAsOneByOneAndNothingElseIsWritten) {
  for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32})
    for (const int count : {0, 1, 7, 8, 9, 16, 33}) {
      const PixelFormat format(depth, Blend::linear);
      Random r(5);
      ColorRow row;
      row.room_for(std::size_t(count));
      std::vector<float> carries(std::size_t(count) + kColorSpare, 0.5f);
      std::vector<std::byte> all((std::size_t(count) + 1) * format.bytes(), std::byte{77});
      for (std::size_t i = 0; i < std::size_t(count); ++i) {
        const Rgba c = rgba_from_mix(random_mix(r, i % 2));
        row.r[i] = c.r, row.g[i] = c.g, row.b[i] = c.b, row.a[i] = c.a;
        carries[i] = float(r.unit());
      }
      format.put(row.planes(), carries.data(), count, all.data());
      for (std::size_t i = 0; i < std::size_t(count); ++i) {
        const ColorPlanes from{&row.r[i], &row.g[i], &row.b[i], &row.a[i]};
        std::array<std::byte, 16> one;
        format.put(from, &carries[i], 1, one.data());
        ASSERT_EQ(0, std::memcmp(one.data(), all.data() + i * format.bytes(), format.bytes())) << i;
      }
      for (std::size_t i = std::size_t(count) * format.bytes(); i < all.size(); ++i)
        ASSERT_EQ(all[i], std::byte{77});
    }
}

TEST(PixelFormat, ScatteredPixelsAreWhereTheirColumnsSay) {
  for (const std::size_t bytes : {4, 8, 16}) {
    std::vector<std::byte> from(3 * bytes), to(10 * bytes);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = std::byte(i + 1);
    const std::array<int, 3> columns{7, 0, 3};
    scatter_pixels(from.data(), columns, bytes, to.data());
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(0, std::memcmp(&to[std::size_t(columns[i]) * bytes], &from[i * bytes], bytes));
    EXPECT_EQ(to[bytes], std::byte{0});
  }
}

}  // namespace
}  // namespace mien::test
