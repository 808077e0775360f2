#pragma once
// The exact form of a region's part of a pixel, and that form in cells.
//
// A region enters a pixel from the left and across the stretches of outline inside it. Both are kept as they come;
// areas and centroids of n × n cells are computed from them on demand.

#include <array>
#include <span>
#include <vector>

namespace mien {

/// A stretch of outline within a pixel, downwards: a parabola by its ends and its middle, seen from the
/// pixel's top left corner.
struct PartStretch {
  float xp, yp, xm, ym, xq, yq;
  float sign;  ///< 1: the region lies to its right, −1: to its left
};

/// How much of a pixel's left border a region has, by thirty-second of the row.
struct PartEntry {
  static constexpr int kRows = 32;
  std::array<float, kRows> height{};
  std::array<float, kRows> moment{};  ///< about the thirty-second's middle

  /// All of the border.
  static PartEntry whole();
  /// Adds what the stretch leaves to its right: what enters the pixels there.
  void add(const PartStretch& stretch);
};

struct PartForm {
  PartEntry left;
  std::span<const PartStretch> stretches;
};

/// A straight stretch, downwards, seen from the pixel's top left corner.
struct PartChord {
  float xp, yp, xq, yq;
  float sign;  ///< 1: the region lies to its right, −1: to its left
};

/// The form by straight stretches, those at the left border for what enters there. Within 2e-4 px² each.
void chords_of_form(const PartForm& form, std::vector<PartChord>& to);

/// The cells of a pixel, row by row. Places are seen from the pixel's middle.
struct PartCells {
  static constexpr int kMostSide = 32, kMost = kMostSide * kMostSide;
  int side = 4;
  alignas(64) std::array<float, kMost> area;  ///< in pixels; 0: nothing
  alignas(64) std::array<float, kMost> x, y;  ///< centroids; of cells without area the middle

  int count() const { return side * side; }
  float cell() const { return 1.0f / float(side); }
};

/// The whole pixel in side × side cells: 1, 2, 4, 8, 16 or 32.
const PartCells& whole_cells(int side);

/// Sixteen squares of the pixel, each within one of its thirty-seconds, and what a form has of them.
struct PartSquares {
  static constexpr std::size_t kCount = 16;
  float side = 0;
  alignas(64) std::array<float, kCount> left, top;   ///< corners, from the pixel's
  alignas(64) std::array<float, kCount> area, x, y;  ///< as of cells
};
void squares_of_form(const PartForm& form, PartSquares& to);

/// The form's cells. Within 2e-4 px² each; if they may be coarse, within 1e-3 px².
void cells_of_form(const PartForm& form, int side, PartCells& to, bool coarse = false);

}  // namespace mien
