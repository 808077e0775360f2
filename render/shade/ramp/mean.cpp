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
    const double least = std::min(s.xa, s.xb);
    for (int i = std::clamp(int(least * cells.side), 0, cells.side - 1); i < cells.side; ++i)
      add_to_cell(row, i, s, sign);
  }

  /// What passes left of the cell counts as at its left side, what passes right of it not at all.
  void add_to_cell(int row, int column, const CellChord& s, double sign) {
    const double left = column / double(cells.side), right = (column + 1) / double(cells.side);
    const auto y_at = [&](double x) {
      const double wide = s.xb - s.xa;
      const double u = wide != 0.0 ? std::clamp((x - s.xa) / wide, 0.0, 1.0) : double(x > s.xa);
      return s.ya + u * (s.yb - s.ya);
    };
    const double at_left = y_at(left), at_right = y_at(right);
    const bool rightwards = s.xb >= s.xa;
    const double from = rightwards ? s.ya : at_left, to = rightwards ? at_left : s.yb;
    add_in_cell(row, column, {left, from, left, to}, right, sign);
    add_in_cell(row, column,
                rightwards ? s.between(at_left, at_right) : s.between(at_right, at_left), right,
                sign);
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
  Mix sum{0.0};
  for (const RampPlane& plane : cells.planes) sum += ramp.box_mean(plane, 1.0 / cells.side);
  return sum / double(cells.planes.size());
}

Mix ramp_mean(const RampIntegral& ramp, const RampCells& cells, std::span<const PartChord> chords) {
  CellIntegral integral{ramp, cells};
  for (const PartChord& chord : chords) integral.add(chord);
  if (!(integral.area > kNothing)) return ramp_mean(ramp, cells);
  const Mix mean = ramp.mean() + integral.sum / integral.area;
  return glm::clamp(mean, ramp.least(), ramp.most());
}

}  // namespace mien
