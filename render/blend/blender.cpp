#include <mien/render/blend/blender.h>
#include <mien/render/blend/transfer.h>

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

template <class Channel>
void store_levels(const Mix& mix, Blend blend, void* pixel) {
  constexpr int kTop = Channel(-1);
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

void store(const Mix& mix, Blend blend, Depth depth, void* pixel) {
  switch (depth) {
    case Depth::u8:
      return store_levels<std::uint8_t>(mix, blend, pixel);
    case Depth::u16:
      return store_levels<std::uint16_t>(mix, blend, pixel);
    case Depth::f32:
      return store_light(mix, blend, pixel);
  }
}

}  // namespace mien
