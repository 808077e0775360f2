#pragma once
// Where a piece of outline meets the borders of rows of pixels: the roots that drawing is made of,
// several at a time.

#include <mien/sdf/outline/outlines.h>

#include <array>

namespace mien {

/// Of a stretch of a piece: its parameter and x where it begins, at each border of rows it passes, and
/// where it ends.
struct RowRoots {
  static constexpr int kRows = 16, kSpare = 8;
  std::array<double, kRows + kSpare> t, x;
};

/// The stretch from `top`, in `first_row`, to `bottom`, in the last of `rows` rows, kRows at most.
///
/// With d = y − y0:  t = d / (a.y + sqrt(a.y² + b.y d)),  as in sdf/arrange/sweep_piece.h.
void row_roots(const OutlinePiece& piece, double top, double bottom, int first_row, int rows,
               RowRoots& to);

}  // namespace mien
