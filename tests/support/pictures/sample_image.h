#pragma once
#include <mien/image.h>

#include <cstdint>
#include <cstring>

namespace mien::test {

/// A picture in which every pixel and channel differs from its neighbours; alpha from none to full
/// if not opaque.
inline Image sample_image(int width, int height, Depth depth, bool opaque) {
  Image image{width, height, depth, opaque, {}};
  image.bytes.resize(image.stride() * std::size_t(height));
  const std::size_t size = bytes_per_channel(depth);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 4; ++c) {
        std::byte* at = image.bytes.data() + image.stride() * std::size_t(y) +
                        (std::size_t(x) * 4 + std::size_t(c)) * size;
        const int level =
            c == 3 && opaque ? 65535 : (x * 977 + y * 3001 + c * 20011 + 7 * x * y) & 65535;
        const float alpha =
            opaque ? 1.0f : float((x * 977 + y * 3001 + 60033 + 7 * x * y) & 65535) / 65535.0f;
        const std::uint8_t u8 = std::uint8_t(level >> 8);
        const std::uint16_t u16 = std::uint16_t(level);
        const float f32 = c == 3 ? alpha : float(level) / 65535.0f * alpha;
        std::memcpy(at,
                    depth == Depth::u8    ? (const void*)&u8
                    : depth == Depth::u16 ? (const void*)&u16
                                          : &f32,
                    size);
      }
    }
  }
  return image;
}

}  // namespace mien::test
