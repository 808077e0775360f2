#pragma once
// A PNG's chunks as bytes (ISO/IEC 15948, 5.3), and those that all of mien's PNGs begin with.

#include "render/image/png/png_strip.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace mien {

using PngBytes = std::vector<std::byte>;

/// Big-endian: 32 bits, 16 bits.
void add_png_number(PngBytes& to, std::uint32_t n);
void add_png_short(PngBytes& to, std::uint32_t n);

/// A chunk's frame: its length and name, what is added behind it, then its check sum.
std::size_t begin_png_chunk(PngBytes& to, const char* name);
void end_png_chunk(PngBytes& to, std::size_t begin);

/// A chunk of numbers of 32 bits.
void add_png_chunk(PngBytes& to, const char* name, std::span<const std::uint32_t> numbers);
/// A text, with its key.
void add_png_text(PngBytes& to, std::string_view key, std::string_view text);

/// The signature, the header, and the colour space: sRGB.
void add_png_head(PngBytes& to, const PngPixels& pixels, int height);

/// What a zlib stream begins with.
inline constexpr std::byte kZlibHead[2] = {std::byte(0x78), std::byte(0x9c)};

/// How many rows are one strip: long enough that the cuts cost nothing, short enough to stop soon. How a stream is cut follows
/// from the picture alone.
int png_strip_rows(const PngPixels& pixels);
inline constexpr int kMostPngStripRows = 256;

}  // namespace mien
