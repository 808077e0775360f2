#pragma once
// A square seen as 4 × 4 cells: what of each lies in a zone, and its colour. Ridges, where two feet
// are as near, and the zone's own ends cut cells in closed form.
//
// A ridge is found by its far side: each of the eight neighbours tells, by its distance, gradient and
// bend, what its foot's distance would be here. Where its gradient is another one, the ridge lies where
// the two distances agree. So nothing need be known of the shape.

#include <mien/render/shade/lamp_lanes.h>

#include <array>

namespace mien {

struct LitCells {
  static constexpr int kSide = 4, kRow = kSide + 2, kPlaces = kRow * kRow;
  static constexpr int kCells = kSide * kSide;

  // Given: the middles of the cells and of their neighbours all around, by row.
  float x, y, side;  ///< the square's middle, from the tile's; a cell's side
  std::array<float, kPlaces> d, nx, ny, bend;
  float shallow, deep;  ///< the zone's depths

  // Found, by cell.
  std::array<float, kCells> area;  ///< share of the cell
  std::array<float, kCells> r, g, b;
  std::array<float, kCells> cx, cy;  ///< centroid of what counts, from the square's middle
  std::array<float, kCells> divide;  ///< not 0: two cuts meet in the cell, look closer
};

/// Areas and centroids alone, without ridges: for parts that something else cuts, too.
void color_cells(const LampLanes& lamp, LitCells& cells);

}  // namespace mien
