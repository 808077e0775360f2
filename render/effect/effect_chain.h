#pragma once
// Effects on images: mosaic and grid, row by row, so that a picture may be larger than memory.
//
//   EffectChain chain(effects, width, height, [&](float* row) { … });
//   while (chain.next(row)) …     // from the top; reads as much of the picture as it needs
//
// Pixels are RGBA floats, linear light, premultiplied. A chain holds the sums of one or two rows of tiles,
// never the picture.

#include <mien/api.h>
#include <mien/effect.h>
#include <mien/expected.h>
#include <mien/image.h>

#include <functional>
#include <memory>
#include <vector>

namespace mien {

/// Checks that an effect is possible at this width: no more tiles than pixels across, and lines no wider
/// than cells.
MIEN_API Expected<Done> check_effect(const Effect& effect, int width);

/// Those that change pictures of this width: as many tiles as pixels without a border do not, nor lines without width
/// or colour. A picture without any is the picture itself, byte for byte at every depth.
MIEN_API std::vector<Effect> acting_effects(const std::vector<Effect>& effects, int width);

/// Gives the next row, in order from the top. False if there is none, or it could not be made.
using NextRow = std::function<bool(float* row)>;

class RowEffect;  // effect_chain.cpp

class MIEN_API EffectChain {
 public:
  /// Effects act in order on the picture that `in` gives; each must have passed check_effect.
  EffectChain(const std::vector<Effect>& effects, int width, int height, NextRow in);
  EffectChain(EffectChain&&) noexcept;
  ~EffectChain();

  /// The next row with all effects. False if the picture ended before the row was complete.
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
