#pragma once
// What the cells of a tile's pixel are seen to be, for the tests of render/shade.

#include "render/shade/light/light_tile.h"

#include <array>
#include <glm/vec2.hpp>

namespace mien::test {

/// The colours at the centroids of 4 × 4 cells of pixel (i, j) of the tile from (16, 16) on.
struct SeenCells {
  std::array<std::array<float, PartCells::kMost>, 4> c;
  PartCells cells;
};
inline void see(LightTile& tile, int i, int j, SeenCells& to) {
  to.cells = whole_cells(4);
  colors_of_cells(tile, i, j, to.cells,
                  {to.c[0].data(), to.c[1].data(), to.c[2].data(), to.c[3].data()});
}
/// Of the tile from (16, 16) on.
inline glm::dvec2 place(const SeenCells& seen, int i, int j, std::size_t k) {
  return glm::dvec2{16.5 + i, 16.5 + j} + glm::dvec2{seen.cells.x[k], seen.cells.y[k]};
}

/// A square around pixel (i, j) has a bicubic that serves it.
inline bool in_a_smooth_square(const LightTile& tile, int i, int j) {
  for (int level = 0; level < LightTile::kLevels; ++level) {
    const int side = LightTile::kSide >> level;
    const auto square = std::size_t(LightTile::square(level, i / side, j / side));
    if (tile.state[square] == LightTile::State::smooth) return true;
  }
  return false;
}

}  // namespace mien::test
