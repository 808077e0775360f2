#include "render/shade/ramp/mean.h"

#include <algorithm>
#include <glm/common.hpp>

namespace mien {
namespace {

/// What is left of a part's area by chords.
constexpr double kNothing = 1e-7;  // [px²]

struct CellChord {
  double xa, ya, xb, yb;

  /// x at a height within it.
  double x_at(double y) const { return yb > ya ? xa + (xb - xa) * (y - ya) / (yb - ya) : xa; }
  CellChord between(double from, double to) const { return {x_at(from), from, x_at(to), to}; }
};

/// Adds up what lies right of chords, cell by cell.
struct CellIntegral {
  const RampIntegral& ramp;
  const RampCells& cells;
  Mix sum{0.0};
  double area = 0;

  void add(const PartChord& chord) {
    const CellChord s{chord.xp, chord.yp, chord.xq, chord.yq};
    const double side = double(cells.side);
    const int last = std::clamp(int(s.yb * side), 0, cells.side - 1);
    for (int row = std::clamp(int(s.ya * side), 0, cells.side - 1); row <= last; ++row) {
      const double from = std::max(s.ya, row / side),
                   to = row == last ? s.yb : std::min(s.yb, (row + 1) / side);
      if (to > from) add_in_row(row, s.between(from, to), double(chord.sign));
    }
  }

  void add_in_row(int row, const CellChord& s, double sign) {
    const double side = double(cells.side), least = std::min(s.xa, s.xb);
    for (int i = std::clamp(int(least * side), 0, cells.side - 1); i < cells.side; ++i) {
      const double left = i / side, right = i + 1 < cells.side ? (i + 1) / side : 1.0;
      if (cells.side == 1 || (s.xa >= left && s.xb >= left && s.xa <= right && s.xb <= right))
        add_in_cell(row, i, s, right, sign);
      else
        add_clipped(row, i, s, left, right, sign);
    }
  }

  /// Of a chord that leaves the cell: all of the cell where it passes to the left, nothing where to the right.
  void add_clipped(int row, int column, const CellChord& s, double left, double right,
                   double sign) {
    const auto y_at = [&](double x) {
      return std::clamp(s.ya + (s.yb - s.ya) * (x - s.xa) / (s.xb - s.xa), s.ya, s.yb);
    };
    if (std::max(s.xa, s.xb) <= left)
      return add_in_cell(row, column, {left, s.ya, left, s.yb}, right, sign);
    const double at_left = std::min(s.xa, s.xb) < left ? y_at(left)
                           : s.xa < s.xb               ? s.ya
                                                       : s.yb,
                 at_right = std::max(s.xa, s.xb) > right ? y_at(right)
                            : s.xa < s.xb                ? s.yb
                                                         : s.ya;
    if (s.xa < s.xb) {
      add_in_cell(row, column, {left, s.ya, left, at_left}, right, sign);
      add_in_cell(row, column, s.between(at_left, at_right), right, sign);
    } else {
      add_in_cell(row, column, s.between(at_right, at_left), right, sign);
      add_in_cell(row, column, {left, at_left, left, s.yb}, right, sign);
    }
  }

  void add_in_cell(int row, int column, const CellChord& s, double right, double sign) {
    if (!(s.yb > s.ya)) return;
    const double cell = 1.0 / cells.side, x = (column + 0.5) * cell, y = (row + 0.5) * cell;
    const RampPlane& plane = cells.planes[std::size_t(row * cells.side + column)];
    sum += sign * ramp.right_of(plane, s.xa - x, s.ya - y, s.xb - x, s.yb - y, right - x);
    area += sign * (s.yb - s.ya) * (right - 0.5 * (s.xa + s.xb));
  }
};

}  // namespace

Mix ramp_mean(const RampIntegral& ramp, const RampCells& cells) {
  return ramp.sum_of_boxes(cells.planes, 1.0 / cells.side) / double(cells.planes.size());
}

Mix ramp_mean(const RampIntegral& ramp, const RampCells& cells, std::span<const PartChord> chords) {
  CellIntegral integral{ramp, cells};
  for (const PartChord& chord : chords) integral.add(chord);
  if (!(integral.area > kNothing)) return ramp_mean(ramp, cells);
  const Mix mean = ramp.mean() + integral.sum / integral.area;
  return glm::clamp(mean, ramp.least(), ramp.most());
}

}  // namespace mien
