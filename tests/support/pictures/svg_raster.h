#pragma once
// What an SVG file shows, by samples. Knows what mien writes: paths of M, l, q and z, rects, groups, clipPaths, linear
// and radial gradients, opacities and mix-blend-mode; anything else is an error. Shares no code with mien: curves are
// cut into short lines, and what is inside is counted along rows of samples.

#include <array>
#include <string>
#include <vector>

#include "tests/support/pictures/svg_tree.h"

namespace mien::test {

/// Colours of a pixel, 0 … 1, straight, red first; the last is the opacity.
using SvgPixel = std::array<double, 4>;

struct SvgRaster {
  int width = 0, height = 0;
  std::vector<SvgPixel> pixels;
  const SvgPixel& at(int x, int y) const { return pixels[std::size_t(y * width + x)]; }
};

/// Samples of every pixel, at the points of a lattice: of a straight edge they tell a pixel's area to about 1/300.
inline constexpr int kSvgSamples = 1597, kSvgStride = 987;  // neighbours of Fibonacci's

/// At the size that the file says, which is whole. Throws std::runtime_error.
SvgRaster svg_raster(const SvgElement& root);

}  // namespace mien::test
