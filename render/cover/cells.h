#pragma once
// The cells that a stretch of a piece of outline crosses, and what it cuts from each.
//
// In a cell (one pixel of one row) a piece that runs from (xp, yp) to (xq, yq) leaves to its right, and
// within its height dy = yq − yp, the area
//
//     a = (right − (xp + xq)/2) dy − (a.x b.y − a.y b.x)/3 · h³,     right: the cell's right border,
//
// a trapezoid and the lens between the arc and its chord: for a parabola the area between an arc of
// parameter length h and its chord is a constant of the curve times h³ (Archimedes). So it is exact.
// All cells farther right lie to its right with dy.

#include "render/cover/row_roots.h"
#include "sdf/outline/outlines.h"

#include <algorithm>
#include <cmath>

namespace mien {

/// A stretch of a piece within one cell.
struct CellStretch {
  int row, column;        ///< column −1: left of the picture
  double xp, yp, xq, yq;  ///< its ends; yp < yq
  double xm, ym;          ///< its middle, by the parameter
  double area;            ///< to its right, in the cell
};

/// A stretch of a piece within one row: where it begins and ends.
struct RowStretch {
  int row;
  double x, y, t, next_x, next_y, next_t;
  int column, last;  ///< of both
};

/// The cells of a row that a stretch crosses.
template <class Sink>
void cells_of_row(const OutlinePiece& p, const RowStretch& s, int width, Sink&& sink) {
  const double lens = (p.ax * p.by - p.ay * p.bx) / 3.0;
  const int step = s.last > s.column ? 1 : -1;
  double x = s.x, y = s.y, t = s.t;
  for (int column = s.column;; column += step) {
    double xq = s.next_x, yq = s.next_y, tq = s.next_t;
    if (column != s.last) {
      xq = step > 0 ? column + 1.0 : column;
      const double d = xq - p.x0, root = std::sqrt(std::max(0.0, p.ax * p.ax + p.bx * d));
      const double divisor = p.ax + step * root;
      tq = std::clamp(divisor != 0.0 ? d / divisor : t, t, s.next_t);
      yq = std::clamp(p.y0 + tq * (2.0 * p.ay + tq * p.by), y, s.next_y);
    }
    if (column < width) {
      const double h = tq - t, dy = yq - y, bulge = 0.25 * h * h;
      sink(CellStretch{s.row, column, x, y, xq, yq, 0.5 * (x + xq) - bulge * p.bx,
                       0.5 * (y + yq) - bulge * p.by,
                       column < 0 ? dy : (column + 1 - 0.5 * (x + xq)) * dy - lens * h * h * h});
    }
    if (column == s.last) break;
    x = xq, y = yq, t = tq;
  }
}

/// The k-th row of a range, from what the lanes found.
inline RowStretch row_stretch(const RowRange& range, const RowRoots& at, int k) {
  const auto i = std::size_t(k);
  const int row = range.first_row + k;
  const double top = k > 0 ? row : range.top, bottom = k + 1 < range.rows ? row + 1 : range.bottom;
  return {row,    at.x[i],     top,          at.t[i],         at.x[i + 1],
          bottom, at.t[i + 1], at.column[i], at.column[i + 1]};
}

/// Calls sink(RowRange) for the rows between two heights, as many at once as roots are found.
template <class Sink>
void ranges_of(double top, double bottom, int width, Sink&& sink) {
  const int last_row = std::max(int(std::ceil(bottom)) - 1, int(top));
  for (int first = int(top); first <= last_row; first += RowRoots::kRows) {
    const int rows = std::min(RowRoots::kRows, last_row + 1 - first);
    sink(RowRange{std::max(top, double(first)), std::min(bottom, double(first + rows)), first, rows,
                  width});
  }
}

/// One row alone: done before lanes are filled. The same bits as row_roots().
inline RowStretch row_stretch(const OutlinePiece& p, const RowRange& range) {
  const auto parameter = [&](double y) {
    const double d = y - p.y0, divisor = p.ay + std::sqrt(std::max(0.0, p.ay * p.ay + p.by * d));
    return divisor > 0.0 ? d / divisor : 0.0;
  };
  const double t = parameter(range.top), u = parameter(range.bottom),
               x = p.x0 + t * (2.0 * p.ax + t * p.bx), v = p.x0 + u * (2.0 * p.ax + u * p.bx);
  const auto column = [&](double at) {  // floor()
    const double held = std::min(std::max(at, -1.0), double(range.width));
    return int(held) - int(held < int(held));
  };
  return {range.first_row, x, range.top, t, v, range.bottom, u, column(x), column(v)};
}

/// Calls sink(CellStretch) for the cells that the piece crosses between two heights, from the top down. Columns
/// beyond `width` are left out, those left of 0 are reported as −1.
template <class Sink>
void cells_of(const OutlinePiece& p, double top, double bottom, int width, Sink&& sink) {
  ranges_of(top, bottom, width, [&](const RowRange& range) {
    RowRoots at;
    row_roots(p, range, at);
    for (int k = 0; k < range.rows; ++k) cells_of_row(p, row_stretch(range, at, k), width, sink);
  });
}

}  // namespace mien
