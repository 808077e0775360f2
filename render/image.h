#pragma once
// Pixels in memory.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien {

/// The type and encoding of one channel of one pixel.
enum class Depth {
  u8,   ///< 0 … 255, sRGB-encoded
  u16,  ///< 0 … 65535, sRGB-encoded
  f32   ///< linear light, premultiplied by alpha
};

inline std::size_t bytes_per_channel(Depth depth) {
  return depth == Depth::u8 ? 1 : depth == Depth::u16 ? 2 : 4;
}

/// RGBA, rows from the top, no padding. u8 and u16 have straight (not premultiplied) alpha.
struct Image {
  int width = 0, height = 0;
  Depth depth = Depth::u8;
  bool opaque = true;  ///< every alpha is full, so it may be stored as RGB
  std::vector<std::byte> bytes;

  std::size_t stride() const { return std::size_t(width) * 4 * bytes_per_channel(depth); }
  const std::uint8_t* row(int y) const {
    return reinterpret_cast<const std::uint8_t*>(bytes.data()) + stride() * std::size_t(y);
  }
};

/// Pixels that the caller owns: RGBA as in Image, with rows `stride` bytes apart.
struct PixelBuffer {
  void* data = nullptr;
  std::size_t stride = 0;  ///< [bytes]
  Depth depth = Depth::u8;
};

}  // namespace mien
