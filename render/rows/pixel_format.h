#pragma once
// From mixed colours to the bytes of pixels: the SIMD twins of store() and store_dithered()
// (render/blend/blender.h), within a hundredth of a level of 255 and half a level of 65535.

#include "render/blend/blender.h"
#include "render/blend/transfer.h"
#include "render/shade/color_row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mien {

/// A premultiplied colour in the blending space, as rows sum it.
struct Rgba {
  float r = 0, g = 0, b = 0, a = 0;
};
inline Rgba operator+(const Rgba& x, const Rgba& y) {
  return {x.r + y.r, x.g + y.g, x.b + y.b, x.a + y.a};
}
inline Rgba operator-(const Rgba& x, const Rgba& y) {
  return {x.r - y.r, x.g - y.g, x.b - y.b, x.a - y.a};
}
inline Rgba operator*(float k, const Rgba& x) {
  return {k * x.r, k * x.g, k * x.b, k * x.a};
}
inline Rgba rgba_from_mix(const Mix& m) {
  return {float(m.r), float(m.g), float(m.b), float(m.a)};
}

/// Colours on their way to pixels.
struct PixelWork {
  ColorPlanes from;
  const float*
      carry;  ///< is added before rounding down: a half, or a dither's threshold; spare, too
  int count;
  Blend blend;
  Depth depth;
  std::byte* to;
};
void put_pixels(const PixelWork& work);

/// How the pixels of one picture are written.
class PixelFormat {
 public:
  PixelFormat(Depth depth, Blend blend) : depth_(depth), blend_(blend) {}

  std::size_t bytes() const { return 4 * bytes_per_channel(depth_); }
  Depth depth() const { return depth_; }
  Blend blend() const { return blend_; }

  void put(const ColorPlanes& from, const float* carry, int count, std::byte* to) const {
    put_pixels({from, carry, count, blend_, depth_, to});
  }

  /// How steeply a colour's darkest channel is encoded; 1 where colours are mixed as encoded.
  double steepness(const Rgba& mix) const {
    if (blend_ != Blend::linear) return 1.0;
    const double up = mix.a > 0.0f ? 1.0 / double(mix.a) : 1.0;
    return encoding_slope(up * double(std::min({mix.r, mix.g, mix.b})));
  }

 private:
  Depth depth_;
  Blend blend_;
};

/// Writes pixels side by side to columns; `to` is column 0.
void scatter_pixels(const std::byte* from, std::span<const int> columns, std::size_t bytes,
                    std::byte* to);

}  // namespace mien
