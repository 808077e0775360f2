#include "render/image/png/png_strip.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "tests/support/pictures/sample_image.h"
#include "tests/support/pictures/unpacked.h"

namespace mien {
namespace {

using Bytes = std::vector<std::byte>;

Bytes expanded(const std::vector<DeflateToken>& tokens) {
  const std::string bytes = test::expanded(tokens);
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes.data());
  return {begin, begin + bytes.size()};
}

/// Rows as they were before their filters: None, Sub and Up of the standard.
Bytes unfiltered(const Bytes& rows, const PngPixels& pixels) {
  const std::size_t size = pixels.row_bytes() - 1, pixel = pixels.pixel_bytes();
  Bytes out;
  for (std::size_t at = 0; at < rows.size(); at += size + 1) {
    const std::size_t begin = out.size();
    for (std::size_t i = 0; i < size; ++i) {
      const int filter = int(rows[at]);
      const int left = i >= pixel ? int(out[begin + i - pixel]) : 0;
      const int above = begin >= size ? int(out[begin + i - size]) : 0;
      const int add = filter == 0 ? 0 : filter == 1 ? left : above;
      EXPECT_LE(filter, 2);
      out.push_back(std::byte((int(rows[at + 1 + i]) + add) & 255));
    }
  }
  return out;
}

/// The image's channels as the file has them.
Bytes channels(const Image& image, bool opaque) {
  Bytes out;
  const std::size_t channel = bytes_per_channel(image.depth);
  for (std::size_t i = 0; i < image.bytes.size(); i += channel) {
    if (opaque && i / channel % 4 == 3) continue;
    for (std::size_t b = channel; b-- > 0;) out.push_back(image.bytes[i + b]);  // high byte first
  }
  return out;
}

/// Noise in its upper part, below stripes of a few colours.
Image half_flat(int width, int height, Depth depth, bool opaque) {
  Image image = test::sample_image(width, height, depth, opaque);
  const std::size_t pixel = 4 * bytes_per_channel(depth);
  for (std::size_t at = image.stride() * std::size_t(height / 2); at < image.bytes.size(); ++at)
    if (at / pixel % 40 != 0) image.bytes[at] = image.bytes[at - pixel];
  return image;
}

TEST(PngStrip, StripsJoinedAreTheRows) {
  for (const Depth depth : {Depth::u8, Depth::u16}) {
    for (const bool opaque : {true, false}) {
      const Image image = half_flat(161, 50, depth, opaque);
      const PngPixels pixels{image.width, depth, opaque};
      std::vector<DeflateToken> tokens;
      Adler sum;
      PngStrip strip(pixels);
      const auto* rows = image.bytes.data();
      for (int y = 0; y < image.height; y += 7) {
        const int count = std::min(7, image.height - y);
        sum = followed(
            sum, strip.add(rows + image.stride() * std::size_t(y), image.stride(), count, tokens));
      }
      const Bytes filtered = expanded(tokens);
      EXPECT_EQ(unfiltered(filtered, pixels), channels(image, opaque));
      EXPECT_EQ(sum.sum, ::adler32(1, reinterpret_cast<const Bytef*>(filtered.data()),
                                   uInt(filtered.size())));
      EXPECT_EQ(sum.length, filtered.size());
    }
  }
}

/// The filters of the rows of one strip.
std::vector<int> filters(const Image& image) {
  const PngPixels pixels{image.width, image.depth, true};
  std::vector<DeflateToken> tokens;
  PngStrip(pixels).add(image.bytes.data(), image.stride(), image.height, tokens);
  const Bytes rows = expanded(tokens);
  std::vector<int> found;
  for (std::size_t at = 0; at < rows.size(); at += pixels.row_bytes())
    found.push_back(int(rows[at]));
  return found;
}

Image drawn(int (*level)(int x, int y)) {
  Image image{64, 4, Depth::u8, true, {}};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (int c = 0; c < 4; ++c) image.bytes.push_back(std::byte(c == 3 ? 255 : level(x, y)));
    }
  }
  return image;
}

TEST(PngStrip, ChoosesFiltersByWhatRowsAreLike) {
  EXPECT_EQ(filters(drawn([](int x, int) { return x < 30 ? 7 : 90; })), (std::vector{0, 2, 2, 2}))
      << "rows like the one above";
  EXPECT_EQ(filters(drawn([](int x, int y) { return x < 30 + y ? 7 : 90; })),
            (std::vector{0, 0, 0, 0}))
      << "flat art";
  EXPECT_EQ(filters(drawn([](int x, int y) { return 2 * x + y; })), (std::vector{1, 2, 2, 2}))
      << "a slope, steeper to the right than down";
  EXPECT_EQ(filters(drawn([](int x, int y) { return x + 40 * y; })), (std::vector{1, 1, 1, 1}));
}

TEST(PngStrip, TheSameRowsAreTheSameBytes) {
  const Image image = test::sample_image(200, 40, Depth::u8, true);
  PngStrip used({200, Depth::u8, true}), fresh({200, Depth::u8, true});
  std::vector<DeflateToken> first, again, other;
  used.add(image.bytes.data(), image.stride(), 40, first);
  used.add(image.bytes.data() + image.stride(), image.stride(), 20, other);
  used.add(image.bytes.data(), image.stride(), 40, again);
  EXPECT_EQ(first, again);
  again.clear();
  fresh.add(image.bytes.data(), image.stride(), 40, again);
  EXPECT_EQ(first, again);
}

TEST(Adler, FollowedIsTheSumOfBoth) {
  std::mt19937 dice(3);
  for (int round = 0; round < 200; ++round) {
    std::string a(dice() % 9000, '\0'), b(dice() % 9000, '\0');
    for (char& c : a) c = char(dice() | 128);
    for (char& c : b) c = char(dice() | 128);
    const auto of = [](const std::string& s) {
      return Adler{
          std::uint32_t(::adler32(1, reinterpret_cast<const Bytef*>(s.data()), uInt(s.size()))),
          s.size()};
    };
    EXPECT_EQ(followed(of(a), of(b)).sum, of(a + b).sum);
  }
  for (int round = 0; round < 200; ++round) {
    const std::uint64_t pixel = std::uint64_t(dice()) << 32 | dice();
    const std::size_t size = 1 + dice() % 8, count = 1 + dice() % (round % 50 ? 300 : 1 << 20);
    std::string run;
    for (std::size_t i = 0; i < size * count; ++i) run += char(pixel >> 8 * (i % size) & 255);
    EXPECT_EQ(adler_of(pixel, size, count).sum,
              ::adler32(1, reinterpret_cast<const Bytef*>(run.data()), uInt(run.size())));
  }
  EXPECT_EQ(adler_of(~std::uint64_t(0), 8, 1 << 20).length, 8u << 20);
  // Lengths beyond 32 bits: zeros leave the low half alone and add it to the high one each time.
  EXPECT_EQ(followed({0x00020003, 5}, {1, 65521ull << 20}).sum, 0x00020003u);
}

}  // namespace
}  // namespace mien
