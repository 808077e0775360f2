#pragma once
// Integrals of a ramp: what means over pixels need, whatever the number of its kinks.
//
// A ramp is piecewise linear, so its antiderivative is piecewise quadratic and the antiderivative of that piecewise
// cubic. Both are kept by piece, of the colour less its mean: over a period they then return to where they began, so
// that a place costs the same, and is as exact, wherever it is. docs/derivations/ramps.md has the formulas.

#include "render/blend/ramp.h"
#include "render/shade/ramp/piece_index.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace mien {

/// Where a place along a gradient is a linear function of the point: t + gx x + gy y.
struct RampPlane {
  double t, gx, gy;

  double at(double x, double y) const { return t + (gx * x + gy * y); }
};

class RampIntegral {
 public:
  /// Of a plane's slope: what is narrower is integrated by places, not by differences. Differences lose digits, places
  /// smear a jump; both stay below 2e-4 of it.
  static constexpr double kNarrow = 1e-3;
  /// What is narrow of a plane; all of one that is as good as level.
  static double narrow(const RampPlane& plane) {
    return std::max(kNarrow * (std::abs(plane.gx) + std::abs(plane.gy)), 1e-150);
  }

  void make(const Ramp& ramp);

  /// A period's mean; of a ramp that does not repeat the middle of its ends.
  const Mix& mean() const { return mean_; }
  /// What a channel changes by at most per t; endless where it jumps.
  double steepest() const { return steepest_; }
  /// In t; 0: it does not repeat.
  double period() const { return index_.period() * length_; }
  /// By channel.
  const Mix& least() const { return least_; }
  const Mix& most() const { return most_; }
  /// What a channel changes by at most.
  double range() const { return largest(most_ - least_); }

  /// The plane in the unit that the other functions take: of t from the first stop to the last one.
  RampPlane scaled(const RampPlane& plane) const;

  /// The integral of the colour less mean() over what lies right of a chord from (xa, ya) to (xb, yb), up to
  /// x = `right`, where the plane (scaled) says which place is where.
  Mix right_of(const RampPlane& plane, double xa, double ya, double xb, double yb,
               double right) const;

  /// The mean over a box with its middle where the plane counts from, `width` wide and as high.
  Mix box_mean(const RampPlane& plane, double width) const;
  /// Whether there is no kink within `reach` of s, so that means are the colour at a mean place; what they are then.
  bool straight(double s, double reach, Mix& color) const;

  /// The means over pixels of row y from x on, of a plane that counts from the picture's corner. Neighbours share a
  /// side; a pixel's bits do not depend on the others.
  void row_means(const RampPlane& plane, int x, int y, std::span<Mix> to) const;

 private:
  /// From a piece's beginning on the second integral of the colour less mean() is c0 + u (c1 + u (c2 + u c3)).
  struct Piece {
    Mix c0, c1, c2, c3;

    Mix second(double u) const { return c0 + u * (c1 + u * (c2 + u * c3)); }
    Mix first(double u) const { return c1 + u * (2.0 * c2 + 3.0 * u * c3); }
    Mix value(double u) const { return 2.0 * c2 + 6.0 * u * c3; }
  };
  void add(std::vector<double>& begins, double begin, const Mix& value, const Mix& slope);
  void sum_up();
  /// The piece at s, which is seen from its beginning then.
  const Piece& at(double& s) const { return pieces_[index_.find(s)]; }
  Mix value(double s) const { return at(s).value(s); }
  Mix first(double s) const { return at(s).first(s); }
  Mix second(double s) const { return at(s).second(s); }
  Mix mean_first(double s, double t, double near) const;

  std::vector<Piece> pieces_;  ///< without a period: before the first stop, …, beyond the last one
  PieceIndex index_;
  Mix mean_{0.0}, least_{0.0}, most_{0.0};
  double from_ = 0, length_ = 1, scale_ = 1;
  double steepest_ = 0;
};

}  // namespace mien
