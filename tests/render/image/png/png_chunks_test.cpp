#include "render/image/png/png_chunks.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <string>

namespace mien {
namespace {

std::string text_of(const PngBytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(PngChunks, HaveLengthNameDataAndSum) {
  PngBytes bytes;
  add_png_chunk(bytes, "gAMA", std::array{0x01020304u});
  const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>("gAMA\1\2\3\4"), 8);
  PngBytes end;
  add_png_number(end, std::uint32_t(sum));
  EXPECT_EQ(text_of(bytes), std::string("\0\0\0\4gAMA\1\2\3\4", 12) + text_of(end));
  PngBytes two;
  add_png_short(two, 0x1234);
  EXPECT_EQ(text_of(two), "\x12\x34");
}

TEST(PngChunks, TextsThatAreNotAsciiAreUtf8) {
  PngBytes ascii, other;
  add_png_text(ascii, "Key", "text");
  add_png_text(other, "Key", "Grün");
  EXPECT_EQ(text_of(ascii).substr(4, 12), std::string("tEXtKey\0text", 12));
  EXPECT_EQ(text_of(other).substr(4, 17), std::string("iTXtKey\0\0\0\0\0Grün", 17));
}

TEST(PngChunks, StripsAreAboutAMebibyte) {
  EXPECT_EQ(png_strip_rows({1 << 20, Depth::u8, false}), 1);
  EXPECT_EQ(png_strip_rows({1024, Depth::u8, true}), 256);
  EXPECT_EQ(png_strip_rows({100000, Depth::u8, true}), 2);
}

}  // namespace
}  // namespace mien
