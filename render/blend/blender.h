#pragma once
// Colours laid over each other, and mixed by area: in linear light or in encoded values, as the
// view says.

#include <mien/color.h>
#include <mien/image.h>
#include <mien/mix_mode.h>
#include <mien/view.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace mien {

/// A colour premultiplied by its opacity, in the space the view blends in. Sums of these, weighted
/// by area, are what a box filter gives.
using Mix = glm::dvec4;

/// Into the blending space.
Mix mix_from_color(const Color& color, Blend blend);

/// The largest absolute value of a channel.
inline double largest(const Mix& m) {
  return std::max({std::abs(m.r), std::abs(m.g), std::abs(m.b), std::abs(m.a)});
}

/// `top` over `below`.
inline Mix over(const Mix& top, const Mix& below) {
  return top + (1.0 - top.a) * below;
}

/// The colour `top` of a group mixed with `below`: the formula of mix_mode.h for premultiplied colours, in which it
/// holds for opacities, too. It is linear in each of the two.
inline Mix blended(MixMode mode, const Mix& top, const Mix& below) {
  switch (mode) {
    case MixMode::normal:
      break;
    case MixMode::multiply:
      return (1.0 - below.a) * top + (1.0 - top.a) * below + top * below;
    case MixMode::screen:
      return top + below - top * below;
  }
  return over(top, below);
}

/// Writes one mixed pixel in the form `depth` asks for (see Image) to `pixel`.
void store(const Mix& mix, Blend blend, Depth depth, void* pixel);

/// The same with an ordered dither: a level is rounded down after adding a threshold between 0 and 1 that depends
/// on the pixel's place in the whole picture (an 8 × 8 Bayer matrix). So no value moves by as much as a level, the
/// mean over 8 × 8 pixels is right to 1/128 of one, and values that are whole levels stay. Float is not dithered.
void store_dithered(const Mix& mix, Blend blend, Depth depth, int x, int y, void* pixel);

/// The threshold of that dither.
double dither_threshold(int x, int y);

}  // namespace mien
