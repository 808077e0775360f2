#pragma once
// Image to image: mosaic and grid, row by row, so that a picture may be larger than the memory.
//
//   EffectChain chain(effects, width, height, [&](const float* rows, int count) { … });
//   chain.push(rows, count);      // from the top; finished rows come out as soon as they are known
//
// Pixels are RGBA floats, linear light, premultiplied. What comes out depends on the picture alone,
// never on how it was cut into pieces.

#include <mien/lib/base/api.h>
#include <mien/lib/base/expected.h>
#include <mien/lib/geom/effect.h>
#include <mien/render/image.h>

#include <functional>
#include <memory>
#include <vector>

namespace mien {

/// Whether an effect is possible on such a picture: no more tiles than pixels across, lines no
/// wider than cells.
MIEN_API Expected<Done> check_effect(const Effect& effect, int width);

/// Takes finished rows, in order from the top.
using TakeRows = std::function<void(const float* rows, int count)>;

class RowEffect;  // effect_chain.cpp

class MIEN_API EffectChain {
 public:
  /// Effects act in order; each must have passed check_effect.
  EffectChain(const std::vector<Effect>& effects, int width, int height, TakeRows out);
  EffectChain(EffectChain&&) noexcept;
  ~EffectChain();

  /// The next `count` rows. After the picture's last row all has come out.
  void push(const float* rows, int count);

 private:
  std::vector<std::unique_ptr<RowEffect>> effects_;
  int width_;
  TakeRows out_;
};

/// A whole picture of linear floats (Depth::f32) with effects.
MIEN_API Image with_effects(const Image& image, const std::vector<Effect>& effects);

/// A picture of linear floats at another depth, rounded as render does.
MIEN_API Image at_depth(const Image& image, Depth depth);

}  // namespace mien
