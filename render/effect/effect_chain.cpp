#include "lib/base/memory_ran_out.h"
#include "row_effect_private.h"

#include "render/blend/blender.h"

#include <fmt/format.h>

#include <cstring>

namespace mien {

Expected<Done> check_effect(const Effect& effect, int width) try {
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
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

std::vector<Effect> acting_effects(const std::vector<Effect>& effects, int width) {
  std::vector<Effect> acting;
  for (const Effect& effect : effects) {
    const auto* mosaic = std::get_if<MosaicEffect>(&effect);
    const auto* grid = std::get_if<GridEffect>(&effect);
    const bool idle = (mosaic && mosaic->tiles == width && mosaic->border == 0) ||
                      (grid && (grid->width == 0 || grid->color.a == 0));
    if (!idle) acting.push_back(effect);
  }
  return acting;
}

EffectChain::EffectChain(const std::vector<Effect>& effects, int width, int height, NextRow in)
    : in_(std::move(in)) {
  for (const Effect& effect : effects)
    effects_.push_back(
        std::visit([&](const auto& e) { return row_effect(e, width, height); }, effect));
}
EffectChain::EffectChain(EffectChain&&) noexcept = default;
EffectChain::~EffectChain() = default;

bool EffectChain::next(float* row) {
  return next_of(effects_.size(), row);
}

bool EffectChain::next_of(std::size_t effects, float* row) {
  if (effects == 0) return in_(row);
  return effects_[effects - 1]->next([&](float* below) { return next_of(effects - 1, below); },
                                     row);
}

Image with_effects(const Image& image, const std::vector<Effect>& effects) {
  Image out = image;
  int read = 0;
  EffectChain chain(effects, image.width, image.height, [&](float* row) {
    if (read == image.height) return false;
    std::memcpy(row, image.row(read++), image.stride());
    return true;
  });
  for (int y = 0; y < out.height; ++y)
    chain.next(reinterpret_cast<float*>(out.bytes.data() + out.stride() * std::size_t(y)));
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
