#include "render/shade/ramp/mean.h"

#include <algorithm>
#include <glm/common.hpp>

namespace mien {
namespace {

/// What is left of a part's area by chords.
constexpr double kNothing = 1e-7;  // [px²]

}  // namespace

void RampPartMean::add(const PartChord& chord) {
  const Chord s{chord.xp, chord.yp, chord.xq, chord.yq};
  const double side = double(side_);
  const int last = std::clamp(int(s.yb * side), 0, side_ - 1);
  for (int row = std::clamp(int(s.ya * side), 0, side_ - 1); row <= last; ++row) {
    const double from = std::max(s.ya, row / side),
                 to = row == last ? s.yb : std::min(s.yb, (row + 1) / side);
    if (to > from) add_in_row(row, s.between(from, to), double(chord.sign));
  }
}

void RampPartMean::add_in_row(int row, const Chord& s, double sign) {
  const double least = std::min(s.xa, s.xb);
  for (int i = std::clamp(int(least * side_), 0, side_ - 1); i < side_; ++i)
    add_to_cell(row, i, s, sign);
}

/// What passes left of the cell counts as at its left side, what passes right of it not at all.
void RampPartMean::add_to_cell(int row, int column, const Chord& s, double sign) {
  const double left = column / double(side_), right = (column + 1) / double(side_);
  const auto y_at = [&](double x) {
    const double wide = s.xb - s.xa;
    const double u = wide != 0.0 ? std::clamp((x - s.xa) / wide, 0.0, 1.0) : double(x > s.xa);
    return s.ya + u * (s.yb - s.ya);
  };
  const double at_left = y_at(left), at_right = y_at(right);
  const bool rightwards = s.xb >= s.xa;
  const double from = rightwards ? s.ya : at_left, to = rightwards ? at_left : s.yb;
  add_in_cell(row, column, {left, from, left, to}, sign);
  add_in_cell(row, column, rightwards ? s.between(at_left, at_right) : s.between(at_right, at_left),
              sign);
}

void RampPartMean::add_in_cell(int row, int column, const Chord& s, double sign) {
  if (!(s.yb > s.ya)) return;
  const double cell = 1.0 / side_, x = (column + 0.5) * cell, y = (row + 0.5) * cell;
  add_right_of(cells_[std::size_t(row * side_ + column)], {s.xa - x, s.ya - y, s.xb - x, s.yb - y},
               0.5 * cell, sign);
  area_ += sign * (s.yb - s.ya) * (x + 0.5 * cell - 0.5 * (s.xa + s.xb));
}

/// The integral over what lies right of a chord, up to x = `right`, where the plane says which place is where.
void RampPartMean::add_right_of(const RampPlane& plane, const Chord& s, double right, double sign) {
  const double near = narrow(plane);
  RampPlane tilted = plane;
  if (std::abs(plane.gx) < near) tilted.gx = std::copysign(near, plane.gx);
  const double by = sign * (s.yb - s.ya) / tilted.gx;
  add_mean(by, tilted.at(right, s.ya), tilted.at(right, s.yb), near);
  add_mean(-by, tilted.at(s.xa, s.ya), tilted.at(s.xb, s.yb), near);
}

/// The mean of the first integral from s to t.
void RampPartMean::add_mean(double weight, double s, double t, double near) {
  if (std::abs(t - s) < near) {
    const double middle = 0.5 * (s + t);
    s = middle - 0.5 * near, t = middle + 0.5 * near;
  }
  const double by = weight / (t - s);
  corners_.push_back({t, by}), corners_.push_back({s, -by});
}

Mix RampPartMean::of(const RampIntegral& ramp, std::span<const RampPlane> cells, int side,
                     std::span<const PartChord> chords) {
  cells_ = cells, side_ = side, area_ = 0.0;
  corners_.clear();
  for (const PartChord& chord : chords) add(chord);
  const Mix mean = ramp.mean() + ramp_sum(ramp, corners_) / std::max(area_, kNothing);
  return glm::clamp(mean, ramp.least(), ramp.most());
}

}  // namespace mien
