#pragma once
// What stretches of outline leave to their right in a pixel: its moments, many at once.

#include "render/cover/part_form.h"

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

/// By stretch, about its pixel's middle, in pixels.
struct PartMoments {
  /// Of what lies right of it in the pixel.
  std::vector<float> x, y, xx, xy, yy;
  /// Of what it leaves of every pixel after it.
  std::vector<float> rest_y, rest_yy;

  /// Exact but for rounding: polynomials of the seventh degree in a parabola's parameter, at four of Gauss's places.
  void make(std::span<const PartStretch> stretches);
};

}  // namespace mien
