#pragma once
// The exact form of a region's part of a pixel, and that form in cells.
//
// A region enters a pixel from the left and across the stretches of outline inside it. Both are kept as they come;
// areas and centroids of n × n cells are computed from them on demand.

#include <array>
#include <span>

namespace mien {

/// A stretch of outline within a pixel, downwards: a parabola by its ends and its middle, seen from the
/// pixel's top left corner.
struct PartStretch {
  float xp, yp, xm, ym, xq, yq;
  float sign;  ///< 1: the region lies to its right, −1: to its left
};

struct PartForm {
  static constexpr int kRows = 32;
  std::array<float, kRows> left{};  ///< what enters from the left, by thirty-second of the row
  std::span<const PartStretch> stretches;
};

/// Adds the stretch's height by thirty-second of the row: what enters the pixels to the right.
void add_height(const PartStretch& stretch, std::array<float, PartForm::kRows>& left);

/// The cells of a pixel, row by row. Places are seen from the pixel's middle.
struct PartCells {
  static constexpr int kMostSide = 32, kMost = kMostSide * kMostSide;
  int side = 4;
  alignas(64) std::array<float, kMost> area;  ///< in pixels; 0: nothing
  alignas(64) std::array<float, kMost> x, y;  ///< centroids; of cells without area the middle

  int count() const { return side * side; }
  float cell() const { return 1.0f / float(side); }
};

/// The whole pixel in side × side cells: 4, 8, 16 or 32.
void whole_cells(int side, PartCells& to);

/// The form's cells. Within 2e-4 px² each, but for a thirty-second of a row where less than all of that row
/// enters from the left.
void cells_of_form(const PartForm& form, int side, PartCells& to);

}  // namespace mien
