#pragma once
// Where a piece of outline meets the borders of rows of pixels: the roots that drawing is made of,
// several at a time.

#include "render/cover/part_form.h"
#include "sdf/outline/outlines.h"

#include <array>

namespace mien {

/// A stretch of a piece: from `top`, in `first_row`, to `bottom`, in the last of `rows` rows.
struct RowRange {
  double top, bottom;
  int first_row, rows;
  int width;  ///< of the picture: columns are −1 left of it, and `width` right of it
};

/// A cell's part of a piece: the area to its right there, and what it leaves of every pixel after.
struct CellPart {
  float area, height;
};

/// Its parameter, x and column where it begins, at each border of rows it passes, and where it ends. For rows in
/// which it stays in one column, or goes on to the next one: its parts of the first, and of the other.
struct RowRoots {
  static constexpr int kRows = 16, kSpare = 8 + 1;
  template <class Number>
  using Rows = std::array<Number, kRows + kSpare>;
  struct Cells {
    Rows<float> area, height;
    Rows<float> xp, yp, xm, ym, xq, yq;  ///< its stretch there, if it is asked for

    CellPart part(std::size_t row) const { return {area[row], height[row]}; }
    PartStretch stretch(std::size_t i) const {
      return {xp[i], yp[i], xm[i], ym[i], xq[i], yq[i], 1.0f};
    }
  };
  Rows<double> t, x;
  Rows<int> column;
  Cells first, second;
};

/// RowRoots::kRows rows at most. With d = y − y0:
///
///     t = d / (a.y + sqrt(a.y² + b.y d)),   as in sdf/arrange/piece_place.h.
void row_roots(const OutlinePiece& piece, const RowRange& range, RowRoots& to,
               bool stretches = false);

}  // namespace mien
