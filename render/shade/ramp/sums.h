#pragma once
// Sums of a ramp's second integral over corners, all channels at once: the one law by which ramps with many stops are
// averaged. A mean over a box, or over what lies right of a chord, is such a sum (docs/derivations/ramps.md).

#include "render/shade/color_row.h"
#include "render/shade/ramp/integral.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace mien {

/// What is narrow of a plane (scaled): narrower slopes count as that. Differences lose digits, width smears a jump; both
/// stay below 2e-4 of it. Of a plane that is level: so little of the ramp.
inline double narrow(const RampPlane& plane) {
  constexpr double kNarrow = 1e-3, kLevel = 1e-12, kLittle = 1e-5;
  const double all = std::abs(plane.gx) + std::abs(plane.gy);
  return all > kLevel ? kNarrow * all : kLittle;
}

/// Boxes that are averaged in groups, each seen from its middle: planes (scaled) and where each group ends. All boxes
/// of a group are as wide and as high, `width` px.
struct RampBoxes {
  struct Group {
    std::size_t end;
    double width;
  };
  std::vector<RampPlane> planes;
  std::vector<Group> groups;

  void clear() { planes.clear(), groups.clear(); }
  void close(double width) { groups.push_back({planes.size(), width}); }
};

/// Writes the groups' means to planes, from the `first` place on; whole vectors.
void ramp_means(const RampIntegral& ramp, const RampBoxes& boxes, ColorRow& to, std::size_t first);

/// A place on a ramp, and how much of its second integral counts.
struct RampCorner {
  double place, weight;
};
Mix ramp_sum(const RampIntegral& ramp, std::span<const RampCorner> corners);

/// The means over pixels of rows of a plane. What rows and pixels share is found once; bits depend on the pixel alone.
class RampRows {
 public:
  /// Of `count` pixels of row y from x on, of a plane (scaled) that counts from the picture's corner.
  void means(const RampIntegral& ramp, const RampPlane& plane, int x, int y, int count,
             ColorRow& to);
  /// Forgets all ramps.
  void clear() {
    for (Line& line : lines_) line.of = nullptr;
  }

 private:
  /// Second integrals along a line of corners, where the place is gx x + at.
  struct Line {
    const RampIntegral* of = nullptr;
    double gx = 0, at = 0;
    int from = 0, until = 0;
    std::vector<double> seconds;  ///< by channel

    const double* from_column(int x) const { return &seconds[4 * std::size_t(x - from)]; }
  };
  Line* known(const RampIntegral& ramp, double gx, double at, int from);
  static void reach(Line& line, const RampIntegral& ramp, double gx, double at, int from,
                    int until);

  std::array<Line, 2> lines_;
  RampBoxes boxes_;
};

}  // namespace mien
