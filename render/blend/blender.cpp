#include "render/blend/blender.h"
#include "render/blend/transfer.h"

#include <algorithm>
#include <cstring>

namespace mien {

Mix mix_from_color(const Color& c, Blend blend) {
  const double a = std::clamp(c.a, 0.0, 1.0);
  const auto in = [&](double v) {
    v = std::clamp(v, 0.0, 1.0);
    return a * (blend == Blend::linear ? v : srgb_from_linear(v));
  };
  return {in(c.r), in(c.g), in(c.b), a};
}

namespace {

/// `carry` decides what becomes of fractions: added before rounding down.
template <class Channel>
void store_levels(const Mix& mix, Blend blend, double carry, void* pixel) {
  constexpr int kTop = Channel(-1);
  const auto level = [&](double v, int top) {
    return v > 0.0 ? int(std::min(v, 1.0) * top + carry) : 0;
  };
  Channel out[4];
  for (int i = 0; i < 3; ++i) {
    const double v = mix.a > 0.0 ? mix[i] / mix.a : 0.0;
    out[i] = Channel(level(blend == Blend::linear ? srgb_from_linear(std::max(v, 0.0)) : v, kTop));
  }
  out[3] = Channel(level(mix.a, kTop));
  std::memcpy(pixel, out, sizeof out);
}

void store_light(const Mix& mix, Blend blend, void* pixel) {
  float out[4];
  for (int i = 0; i < 3; ++i) {
    const double v = mix.a > 0.0 ? mix[i] / mix.a : 0.0;
    out[i] = float(blend == Blend::linear ? mix[i] : mix.a * linear_from_srgb(v));
  }
  out[3] = float(mix.a);
  std::memcpy(pixel, out, sizeof out);
}

}  // namespace

namespace {

void store(const Mix& mix, Blend blend, Depth depth, double carry, void* pixel) {
  switch (depth) {
    case Depth::u8:
      return store_levels<std::uint8_t>(mix, blend, carry, pixel);
    case Depth::u16:
      return store_levels<std::uint16_t>(mix, blend, carry, pixel);
    case Depth::f32:
      return store_light(mix, blend, pixel);
  }
}

}  // namespace

/// The 8 × 8 Bayer matrix, (0.5 … 63.5)/64: the bits of x xor y and y, interleaved and reversed.
double dither_threshold(int x, int y) {
  const unsigned a = unsigned(x ^ y), b = unsigned(y);
  unsigned rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = rank << 2 | (a >> bit & 1u) << 1 | (b >> bit & 1u);
  return (double(rank) + 0.5) / 64.0;
}

void store(const Mix& mix, Blend blend, Depth depth, void* pixel) {
  store(mix, blend, depth, 0.5, pixel);
}

void store_dithered(const Mix& mix, Blend blend, Depth depth, int x, int y, void* pixel) {
  store(mix, blend, depth, dither_threshold(x, y), pixel);
}

}  // namespace mien
