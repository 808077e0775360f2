#include "row_effect_private.h"

#include <mien/render/blend/blender.h>

#include <fmt/format.h>

#include <cstring>

namespace mien {

Expected<Done> check_effect(const Effect& effect, int width) {
  if (const auto* mosaic = std::get_if<MosaicEffect>(&effect); mosaic && mosaic->tiles > width)
    return Error{"", fmt::format("a mosaic of {} tiles across needs as many pixels, not {}",
                                 mosaic->tiles, width)};
  if (const auto* grid = std::get_if<GridEffect>(&effect)) {
    if (grid->cells > width)
      return Error{"", fmt::format("a grid of {} cells across needs as many pixels, not {}",
                                   grid->cells, width)};
    if (grid->width > double(width) / grid->cells)
      return Error{"", fmt::format("lines of {} pixels are wider than the grid's cells of {:.6g}",
                                   grid->width, double(width) / grid->cells)};
  }
  return Done{};
}

EffectChain::EffectChain(const std::vector<Effect>& effects, int width, int height, TakeRows out)
    : width_(width), out_(std::move(out)) {
  for (const Effect& effect : effects)
    effects_.push_back(
        std::visit([&](const auto& e) { return row_effect(e, width, height); }, effect));
}
EffectChain::EffectChain(EffectChain&&) noexcept = default;
EffectChain::~EffectChain() = default;

void EffectChain::push(const float* rows, int count) {
  const std::function<void(std::size_t, const float*, int)> pass = [&](std::size_t i,
                                                                       const float* at, int n) {
    if (i == effects_.size()) return out_(at, n);
    for (int r = 0; r < n; ++r)
      effects_[i]->push(at + 4 * std::size_t(width_) * std::size_t(r),
                        [&](const float* done, int m) { pass(i + 1, done, m); });
  };
  pass(0, rows, count);
}

Image with_effects(const Image& image, const std::vector<Effect>& effects) {
  Image out = image;
  std::byte* to = out.bytes.data();
  const std::size_t stride = image.stride();
  EffectChain chain(effects, image.width, image.height, [&](const float* rows, int count) {
    std::memcpy(to, rows, stride * std::size_t(count));
    to += stride * std::size_t(count);
  });
  chain.push(reinterpret_cast<const float*>(image.bytes.data()), image.height);
  return out;
}

Image at_depth(const Image& image, Depth depth) {
  if (depth == Depth::f32) return image;
  Image out{.width = image.width, .height = image.height, .depth = depth, .opaque = image.opaque};
  out.bytes.resize(out.stride() * std::size_t(out.height));
  const auto* from = reinterpret_cast<const float*>(image.bytes.data());
  const std::size_t pixel = 4 * bytes_per_channel(depth);
  std::byte* to = out.bytes.data();
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  for (std::size_t i = 0; i < count; ++i, from += 4, to += pixel) {
    // Flat art repeats itself.
    if (i > 0 && std::memcmp(from, from - 4, 4 * sizeof(float)) == 0)
      std::memcpy(to, to - pixel, pixel);
    else
      store({from[0], from[1], from[2], from[3]}, Blend::linear, depth, to);
  }
  return out;
}

}  // namespace mien
