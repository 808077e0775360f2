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

#include <mien/sdf/outline/outlines.h>

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

/// Calls sink(CellStretch) for the cells that the piece crosses between two heights, from the top
/// down. Columns beyond `width` are left out, those left of 0 are told as −1.
template <class Sink>
void cells_of(const OutlinePiece& p, double top, double bottom, int width, Sink&& sink) {
  const double ay2 = p.ay * p.ay, ax2 = p.ax * p.ax;
  const double lens = (p.ax * p.by - p.ay * p.bx) / 3.0;
  const auto parameter = [&](double y) {
    const double d = y - p.y0, s = std::sqrt(std::max(0.0, ay2 + p.by * d));
    const double divisor = p.ay + s;
    return divisor > 0.0 ? d / divisor : 0.0;
  };
  const auto x_of = [&](double t) { return p.x0 + t * (2.0 * p.ax + t * p.bx); };
  const auto column_of = [&](double x) { return x < 0.0 ? -1 : x >= width ? width : int(x); };
  const int last_row = std::max(int(std::ceil(bottom)) - 1, int(top));
  double y = top, t = parameter(top), x = x_of(t);
  for (int row = int(top); row <= last_row; ++row) {
    const double next_y = row == last_row ? bottom : row + 1.0;
    const double next_t = parameter(next_y), next_x = x_of(next_t);
    int column = column_of(x);
    const int last = column_of(next_x), step = last > column ? 1 : -1;
    double xp = x, yp = y, tp = t;
    for (;; column += step) {
      double xq = next_x, yq = next_y, tq = next_t;
      if (column != last) {
        xq = step > 0 ? column + 1.0 : column;
        const double d = xq - p.x0, s = std::sqrt(std::max(0.0, ax2 + p.bx * d));
        const double divisor = p.ax + step * s;
        tq = std::clamp(divisor != 0.0 ? d / divisor : tp, tp, next_t);
        yq = std::clamp(p.y0 + tq * (2.0 * p.ay + tq * p.by), yp, next_y);
      }
      if (column < width) {
        const double h = tq - tp, dy = yq - yp, bulge = 0.25 * h * h;
        sink(CellStretch{row, column, xp, yp, xq, yq, 0.5 * (xp + xq) - bulge * p.bx,
                         0.5 * (yp + yq) - bulge * p.by,
                         column < 0 ? dy : (column + 1 - 0.5 * (xp + xq)) * dy - lens * h * h * h});
      }
      if (column == last) break;
      xp = xq, yp = yq, tp = tq;
    }
    y = next_y, t = next_t, x = next_x;
  }
}

}  // namespace mien
