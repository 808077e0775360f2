#pragma once
// Image to image: mosaic and grid, row by row, so that a picture may be larger than the memory.
//
//   EffectChain chain(effects, width, height, [&](float* row) { … });
//   while (chain.next(row)) …     // from the top; each asks for as much of the picture as it needs
//
// Pixels are RGBA floats, linear light, premultiplied. A chain holds a row of tiles or two as sums,
// never the picture.

#include <mien/api.h>
#include <mien/effect.h>
#include <mien/expected.h>
#include <mien/image.h>

#include <functional>
#include <memory>
#include <vector>

namespace mien {

/// Whether an effect is possible on such a picture: no more tiles than pixels across, lines no
/// wider than cells.
MIEN_API Expected<Done> check_effect(const Effect& effect, int width);

/// Gives the next row, in order from the top; false: there is none, or it could not be made.
using NextRow = std::function<bool(float* row)>;

class RowEffect;  // effect_chain.cpp

class MIEN_API EffectChain {
 public:
  /// Effects act in order on the picture that `in` gives; each must have passed check_effect.
  EffectChain(const std::vector<Effect>& effects, int width, int height, NextRow in);
  EffectChain(EffectChain&&) noexcept;
  ~EffectChain();

  /// The next row with all effects; false where the picture ended before it was known.
  bool next(float* row);

 private:
  bool next_of(std::size_t effects, float* row);

  std::vector<std::unique_ptr<RowEffect>> effects_;
  NextRow in_;
};

/// A whole picture of linear floats (Depth::f32) with effects.
MIEN_API Image with_effects(const Image& image, const std::vector<Effect>& effects);

/// A picture of linear floats at another depth, rounded as render does.
MIEN_API Image at_depth(const Image& image, Depth depth);

}  // namespace mien
