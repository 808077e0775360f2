#pragma once
// The mean of a ramp over a part of a pixel, by cells in each of which its place is a plane.

#include "render/cover/part_form.h"
#include "render/shade/ramp/sums.h"

#include <span>
#include <vector>

namespace mien {

/// Keeps its scratch.
class RampPartMean {
 public:
  /// Over the part of a pixel that chords bound. `cells` are all of the pixel, side × side of them row by row.
  Mix of(const RampIntegral& ramp, std::span<const RampPlane> cells, int side,
         std::span<const PartChord> chords);

 private:
  struct Chord {
    double xa, ya, xb, yb;

    /// x at a height within it.
    double x_at(double y) const { return yb > ya ? xa + (xb - xa) * (y - ya) / (yb - ya) : xa; }
    Chord between(double from, double to) const { return {x_at(from), from, x_at(to), to}; }
  };
  void add(const PartChord& chord);
  void add_in_row(int row, const Chord& s, double sign);
  void add_to_cell(int row, int column, const Chord& s, double sign);
  void add_in_cell(int row, int column, const Chord& s, double sign);
  void add_right_of(const RampPlane& plane, const Chord& s, double right, double sign);
  void add_mean(double weight, double s, double t, double near);

  std::span<const RampPlane> cells_;
  int side_ = 1;
  double area_ = 0;
  std::vector<RampCorner> corners_;
};

}  // namespace mien
