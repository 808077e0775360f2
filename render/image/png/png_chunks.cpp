#include "render/image/png/png_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>

namespace mien {
namespace {

constexpr std::size_t kStripBytes = std::size_t(1) << 20;  // before compression

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > 0 && c < 0x7f; });
}

}  // namespace

void add_png_number(PngBytes& to, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(std::byte(n >> shift & 255));
}

void add_png_short(PngBytes& to, std::uint32_t n) {
  to.push_back(std::byte(n >> 8 & 255));
  to.push_back(std::byte(n & 255));
}

std::size_t begin_png_chunk(PngBytes& to, const char* name) {
  const std::size_t begin = to.size();
  add_png_number(to, 0);
  for (int i = 0; i < 4; ++i) to.push_back(std::byte(name[i]));
  return begin;
}

void end_png_chunk(PngBytes& to, std::size_t begin) {
  const std::size_t length = to.size() - begin - 8;
  for (std::size_t i = 0; i < 4; ++i) to[begin + i] = std::byte(length >> (24 - 8 * i) & 255);
  add_png_number(to, libdeflate_crc32(0, &to[begin + 4], length + 4));
}

void add_png_chunk(PngBytes& to, const char* name, std::span<const std::uint32_t> numbers) {
  const std::size_t begin = begin_png_chunk(to, name);
  for (const std::uint32_t n : numbers) add_png_number(to, n);
  end_png_chunk(to, begin);
}

// tEXt is Latin-1; iTXt is UTF-8, with flags for compression and a language left empty.
void add_png_text(PngBytes& to, std::string_view key, std::string_view text) {
  const bool ascii = is_ascii(text);
  const std::size_t begin = begin_png_chunk(to, ascii ? "tEXt" : "iTXt");
  const auto add = [&](std::string_view s) {
    for (const char c : s) to.push_back(std::byte(c));
  };
  add(key);
  to.insert(to.end(), ascii ? 1 : 5, std::byte(0));
  add(text);
  end_png_chunk(to, begin);
}

void add_png_head(PngBytes& to, const PngPixels& pixels, int height) {
  for (const int byte : {0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10}) to.push_back(std::byte(byte));
  const std::size_t header = begin_png_chunk(to, "IHDR");
  add_png_number(to, std::uint32_t(pixels.width));
  add_png_number(to, std::uint32_t(height));
  const int depth = pixels.depth == Depth::u8 ? 8 : 16, color = pixels.opaque ? 2 : 6;
  for (const int byte : {depth, color, 0, 0, 0}) to.push_back(std::byte(byte));
  end_png_chunk(to, header);
  // sRGB, and for readers that do not know it the nearest gamma and its primaries.
  add_png_chunk(to, "gAMA", std::array{45455u});
  add_png_chunk(to, "cHRM",
                std::array{31270u, 32900u, 64000u, 33000u, 30000u, 60000u, 15000u, 6000u});
  const std::size_t srgb = begin_png_chunk(to, "sRGB");
  to.push_back(std::byte(0));  // perceptual
  end_png_chunk(to, srgb);
}

int png_strip_rows(const PngPixels& pixels) {
  return int(std::bit_floor(std::clamp<std::size_t>(kStripBytes / pixels.row_bytes(), 1,
                                                    std::size_t(kMostPngStripRows))));
}

}  // namespace mien
