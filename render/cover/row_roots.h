#pragma once
// Where a piece of outline meets the borders of rows of pixels: the roots that drawing is made of,
// several at a time.

#include "sdf/outline/outlines.h"

#include <array>

namespace mien {

/// A stretch of a piece: from `top`, in `first_row`, to `bottom`, in the last of `rows` rows.
struct RowRange {
  double top, bottom;
  int first_row, rows;
  int width;  ///< of the picture: columns are −1 left of it, and `width` right of it
};

/// A cell's part of a piece: the area to its right there, and what it takes of every pixel after.
struct CellPart {
  float area, rest;
};

/// Its parameter, x and column where it begins, at each border of rows it passes, and where it ends. For rows in
/// which it stays in one column, or goes on to the next one: what it adds to the first, and to the other.
struct RowRoots {
  static constexpr int kRows = 16, kSpare = 8 + 1;
  std::array<double, kRows + kSpare> t, x;
  std::array<int, kRows + kSpare> column;
  std::array<float, kRows + kSpare> area, rest, next_area, next_rest;

  CellPart first(std::size_t row) const { return {area[row], rest[row]}; }
  CellPart second(std::size_t row) const { return {next_area[row], next_rest[row]}; }
};

/// RowRoots::kRows rows at most. With d = y − y0:
///
///     t = d / (a.y + sqrt(a.y² + b.y d)),   as in sdf/arrange/piece_place.h.
void row_roots(const OutlinePiece& piece, const RowRange& range, RowRoots& to);

}  // namespace mien
