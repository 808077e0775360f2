#include <mien/render/image/png_strip.h>

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "tests/support/sample_image.h"

namespace mien {
namespace {

using Bytes = std::vector<std::byte>;

/// What a joined stream unpacks to; an empty last block is added.
Bytes unpacked(Bytes stream, std::size_t size) {
  stream.insert(stream.end(), {std::byte(3), std::byte(0)});
  Bytes to(size);
  z_stream z{};
  ::inflateInit2(&z, -15);
  z.next_in = reinterpret_cast<Bytef*>(stream.data());
  z.avail_in = uInt(stream.size());
  z.next_out = reinterpret_cast<Bytef*>(to.data());
  z.avail_out = uInt(to.size());
  EXPECT_EQ(::inflate(&z, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(z.total_out, size);
  ::inflateEnd(&z);
  return to;
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

TEST(PngStrip, StripsJoinedAreTheRows) {
  for (const Depth depth : {Depth::u8, Depth::u16}) {
    for (const bool opaque : {true, false}) {
      const Image image = test::sample_image(61, 50, depth, opaque);
      const PngPixels pixels{image.width, depth, opaque};
      Bytes stream;
      Adler sum;
      PngStrip strip(pixels);
      const auto* rows = image.bytes.data();
      for (int y = 0; y < image.height; y += 7) {
        const int count = std::min(7, image.height - y);
        sum = followed(
            sum, strip.add(rows + image.stride() * std::size_t(y), image.stride(), count, stream));
      }
      const Bytes filtered = unpacked(stream, pixels.row_bytes() * std::size_t(image.height));
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
  Bytes stream;
  PngStrip(pixels).add(image.bytes.data(), image.stride(), image.height, stream);
  const Bytes rows = unpacked(stream, pixels.row_bytes() * std::size_t(image.height));
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
  Bytes first, again, other;
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
  // Lengths beyond 32 bits: zeros leave the low half alone and add it to the high one each time.
  EXPECT_EQ(followed({0x00020003, 5}, {1, 65521ull << 20}).sum, 0x00020003u);
}

}  // namespace
}  // namespace mien
