#pragma once
// The mean light over cells of a pixel, each seen at its centroid.
//
// A ridge, where two feet are equally near and the gradient jumps, cuts cells in closed form. It is found from its
// far side: the distance, gradient and bend at each of a cell's eight neighbours predict how far that neighbour's
// foot is from here. Where its gradient is another one, the ridge lies where the two distances agree. So nothing
// need be known of the shape.

#include "render/cover/part_form.h"
#include "render/shade/light/lamp_lanes.h"

#include <array>
#include <span>

namespace mien {

/// The signed distance at a place, its gradient, and how fast that turns along the level line [1/px].
struct FootAt {
  float d, nx, ny, bend;
};

/// Cells in rows with a margin all around, as ridges ask for.
struct LitCells {
  static constexpr int kMostRow = PartCells::kMostSide + 2;
  static constexpr int kMost = (kMostRow * kMostRow + 15) / 16 * 16 + 32;

  float x, y;           ///< the pixel's middle, from the tile's
  float shallow, deep;  ///< the zone's depths
  int side = 4, row = 4;
  bool ringed =
      false;    ///< one cell more all around, and a foot for each; else `foot` serves for all
  FootAt foot;  ///< at the pixel's middle
  alignas(64) std::array<float, kMost> area, at_x, at_y;  ///< as in PartCells
  /// Where feet are looked for, from the tile's middle: at centroids, since a ridge may run between a centroid and its
  /// cell's middle, and at the middles of cells without area.
  alignas(64) std::array<float, kMost> foot_x, foot_y;
  alignas(64) std::array<float, kMost> d, nx, ny, bend;  ///< there
  alignas(64) std::array<float, kMost> r, g, b;  ///< what mean_of_cells saw, where there is area

  /// Takes all cells with the foot at the pixel's middle; or with a margin, and their feet are then to be found.
  void take(const PartCells& cells, bool ring);
  int places() const { return row * row; }
  /// Where the k-th cell stands.
  std::size_t at(int k) const {
    return std::size_t(ringed ? (k / side + 1) * row + k % side + 1 : k);
  }
};

struct LitMean {
  float r = 0, g = 0, b = 0;
  float area = 0;   ///< of the cells, at least a tenth
  float lean = 0;   ///< how far that plane's colours are from the mean
  float rough = 0;  ///< how far colours are from a plane over the pixel, root mean square
  float jump = 0;   ///< the most that a ridge changes colours by
  /// Share of cells that are cut by two ridges, or by a ridge and an outline, times the change of colour there.
  float unsure = 0;
  float turn = 0;  ///< the most that a gradient turns within a cell
  /// How much the law would vary there without its clamps, if one of them begins there; else 0.
  float kink = 0;
};

LitMean mean_of_cells(const LampLanes& lamp, LitCells& cells);

}  // namespace mien
