#include "render/image/pixel_rows.h"
#include "render/blend/transfer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace mien {
namespace {

int top_level(Depth depth) {
  return depth == Depth::u8 ? 255 : 65535;
}

/// Levels of straight sRGB to premultiplied light, `linear` being the light of each level.
template <class Level>
void to_light(const Level* from, float* to, std::size_t pixels, const std::vector<float>& linear) {
  const float scale = 1.0f / float(linear.size() - 1);
  for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 4) {
    const float alpha = float(from[3]) * scale;
    for (int c = 0; c < 3; ++c) to[c] = linear[from[c]] * alpha;
    to[3] = alpha;
  }
}

/// Premultiplied light to levels of straight sRGB. Flat art repeats itself: a pixel like the one
/// before is copied.
template <class Level>
void to_levels(const float* from, Level* to, std::size_t pixels, int top) {
  for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 4) {
    if (i > 0 && std::memcmp(from, from - 4, 4 * sizeof(float)) == 0) {
      std::copy(to - 4, to, to);
      continue;
    }
    const double alpha = from[3];
    for (int c = 0; c < 3; ++c) {
      to[c] = Level(alpha > 0 ? level(srgb_from_linear(std::clamp(from[c] / alpha, 0.0, 1.0)), top)
                              : 0);
    }
    to[3] = Level(level(alpha, top));
  }
}

/// Between 8 and 16 bits; 65535 = 255 · 257.
void to_other_levels(const std::uint8_t* from, std::uint16_t* to, std::size_t channels) {
  std::transform(from, from + channels, to, [](int v) { return std::uint16_t(v * 257); });
}
void to_other_levels(const std::uint16_t* from, std::uint8_t* to, std::size_t channels) {
  std::transform(from, from + channels, to, [](int v) { return std::uint8_t((v + 128) / 257); });
}

}  // namespace

PixelRows::PixelRows(Depth from, Depth to) : from_(from), to_(to) {
  if (from == Depth::f32 || to != Depth::f32) return;
  const int top = top_level(from);
  linear_.resize(std::size_t(top) + 1);
  for (int v = 0; v <= top; ++v) linear_[std::size_t(v)] = float(linear_from_srgb(double(v) / top));
}

void PixelRows::convert(const void* from, void* to, std::size_t pixels) const {
  if (from_ == to_) {
    std::memcpy(to, from, pixels * 4 * bytes_per_channel(to_));
    return;
  }
  const auto* from8 = static_cast<const std::uint8_t*>(from);
  const auto* from16 = static_cast<const std::uint16_t*>(from);
  const auto* from32 = static_cast<const float*>(from);
  auto* to8 = static_cast<std::uint8_t*>(to);
  auto* to16 = static_cast<std::uint16_t*>(to);
  auto* to32 = static_cast<float*>(to);
  switch (from_) {
    case Depth::u8:
      to_ == Depth::f32 ? to_light(from8, to32, pixels, linear_)
                        : to_other_levels(from8, to16, pixels * 4);
      break;
    case Depth::u16:
      to_ == Depth::f32 ? to_light(from16, to32, pixels, linear_)
                        : to_other_levels(from16, to8, pixels * 4);
      break;
    case Depth::f32:
      to_ == Depth::u8 ? to_levels(from32, to8, pixels, 255)
                       : to_levels(from32, to16, pixels, 65535);
      break;
  }
}

}  // namespace mien
