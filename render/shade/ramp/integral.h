#pragma once
// Integrals of a ramp: what means over pixels need, whatever the number of its kinks.
//
// A ramp is piecewise linear, so its antiderivative is piecewise quadratic and the antiderivative of that piecewise
// cubic. Both are kept by piece, of the colour less its mean: over a period they then return to where they began, so
// that a place costs the same, and is as exact, wherever it is. docs/derivations/ramps.md has the formulas.

#include "render/blend/ramp.h"
#include "render/shade/ramp/piece_index.h"

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
  void make(const Ramp& ramp);
  /// Of a stretch from `from` to `to` alone: beyond it the colours of its ends hold.
  void make(double from, double to, const Mix& first, const Mix& last);

  /// A period's mean; of a ramp that does not repeat the middle of its ends.
  const Mix& mean() const { return mean_; }
  /// What a channel changes by at most per t; endless where it jumps.
  double steepest() const { return steepest_; }
  /// In t; 0: it does not repeat.
  double period() const { return index_.period * length_; }
  /// By channel.
  const Mix& least() const { return least_; }
  const Mix& most() const { return most_; }
  /// What a channel changes by at most.
  double range() const { return largest(most_ - least_); }

  /// A piece's length at most, in the unit of what follows.
  double longest() const { return longest_; }

  /// The plane in the unit of what follows: of t from the first stop to the last one.
  RampPlane scaled(const RampPlane& plane) const;

  /// From a piece's beginning on the second integral of the colour less mean() is c0 + u (c1 + u (c2 + u c3)).
  struct Piece {
    Mix c0, c1, c2, c3;
  };
  const std::vector<Piece>& pieces() const { return pieces_; }
  const PieceIndex& index() const { return index_; }

 private:
  void make(std::span<const double> at, std::span<const Mix> mixes, Extend extend);
  void add(double begin, const Mix& value, const Mix& slope);
  void sum_up();

  std::vector<Piece> pieces_;  ///< without a period: before the first stop, …, beyond the last one
  PieceIndex index_;
  Mix mean_{0.0}, least_{0.0}, most_{0.0};
  double from_ = 0, length_ = 1, scale_ = 1;
  double steepest_ = 0, longest_ = 0;
};

}  // namespace mien
