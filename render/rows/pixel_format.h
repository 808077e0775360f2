#pragma once
// From mixed colours to the bytes of pixels: fast twins of store() and store_dithered()
// (render/blend/blender.h), off by less than a hundredth of a level of 255 and half a level of 65535.

#include <mien/render/blend/blender.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

/// srgb_from_linear by a table of chords: 4096 of them are off by at most 1.8e-5, half of what the
/// steepest bend (at 0.0031, f'' = −2400) allows: h² f'' / 8.
class EncodeTable {
 public:
  EncodeTable();
  float operator()(float linear) const {
    const float x = std::clamp(linear, 0.0f, 1.0f) * kCells;
    const int i = std::min(int(x), kCells - 1);
    const float at = values_[std::size_t(i)];
    return at + (x - float(i)) * (values_[std::size_t(i) + 1] - at);
  }
  static const EncodeTable& shared();

 private:
  static constexpr int kCells = 4096;
  std::array<float, kCells + 1> values_;
};

/// How the pixels of one picture are written.
class PixelFormat {
 public:
  PixelFormat(Depth depth, Blend blend)
      : depth_(depth), blend_(blend), encode_(&EncodeTable::shared()) {}

  std::size_t bytes() const { return 4 * bytes_per_channel(depth_); }
  Depth depth() const { return depth_; }
  Blend blend() const { return blend_; }

  /// One pixel; `carry` is added before rounding down: a half, or a dither's threshold.
  void put(const Rgba& mix, float carry, std::byte* to) const {
    switch (depth_) {
      case Depth::u8:
        return levels<std::uint8_t>(mix, carry, to);
      case Depth::u16:
        return levels<std::uint16_t>(mix, carry, to);
      case Depth::f32:
        return light(mix, to);
    }
  }

  /// How much steeper than itself a colour's darkest channel is encoded.
  double steepness(const Rgba& mix) const {
    if (blend_ != Blend::linear) return 1.0;
    const double up = mix.a > 0.0f ? 1.0 / double(mix.a) : 1.0;
    const double least = up * double(std::min({mix.r, mix.g, mix.b}));
    return least <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(least, 1.0 / 2.4 - 1.0);
  }

 private:
  template <class Channel>
  void levels(const Rgba& mix, float carry, std::byte* to) const {
    constexpr float kTop = Channel(-1);
    const float whole = 1.0f - 0x1p-20f;  // opaque but for the sum's roundings
    Rgba c = mix;
    if (mix.a < whole) {
      const float up = mix.a > 0x1p-20f ? 1.0f / mix.a : 0.0f;
      c = {up * mix.r, up * mix.g, up * mix.b, mix.a};
    }
    if (blend_ == Blend::linear) c = {(*encode_)(c.r), (*encode_)(c.g), (*encode_)(c.b), c.a};
    const auto level = [&](float v) { return Channel(std::clamp(v, 0.0f, 1.0f) * kTop + carry); };
    const Channel out[4] = {level(c.r), level(c.g), level(c.b),
                            mix.a < whole ? level(c.a) : Channel(-1)};
    std::memcpy(to, out, sizeof out);
  }
  void light(const Rgba& mix, std::byte* to) const;

  Depth depth_;
  Blend blend_;
  const EncodeTable* encode_;
};

/// Writes `count` pixels of one value, which is `bytes` long.
void fill_pixels(std::byte* to, int count, const std::byte* value, std::size_t bytes);

}  // namespace mien
