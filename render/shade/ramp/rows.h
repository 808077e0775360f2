#pragma once
// Means over the pixels of rows of a ramp along a line, whose place is one plane: a mean is the difference of one
// function at both sides of a pixel, and its neighbour has one of the two already.

#include "render/shade/color_row.h"
#include "render/shade/ramp/integral.h"

namespace mien {

class RampRows {
 public:
  /// `plane`: of the picture, scaled.
  void make(const RampIntegral& ramp, const RampPlane& plane);

  /// The means of pixels of row y: `count` from x0 + from on, at most kMost. Counted from x0, so that a pixel's bits
  /// depend on that alone. Writes whole vectors.
  void means(int x0, int y, int from, int count, ColorRow& to) const;
  static constexpr int kMost = 64;

  /// The second integral, smeared by how t varies down a pixel: c[0] + u (c[1] + u (c[2] + u c[3])). Of rows along
  /// which t does not vary its slope.
  struct Piece {
    Mix c[4];
  };

 private:
  Piece smeared(const RampIntegral& ramp, double middle, double half) const;

  RampPlane plane_{};
  Mix mean_{0.0};
  bool level_ = false;  ///< t varies along rows by next to nothing
  double offset_ = 0;   ///< where pieces begin
  PieceIndex index_;
  std::vector<Piece> pieces_;
};

/// A row's places: first + i step, one more than `count` of them. A pixel's mean is `mean` and its place's value if the
/// row is level, else per_step times the difference of the next place's value and its own.
struct RampRowPlaces {
  double first, step;
  int from, count;
  bool level;
  double per_step;
  Mix mean;
};

/// The same bits on every machine.
void means_of_ramp_row(const PieceIndex& index, const RampRows::Piece* pieces,
                       const RampRowPlaces& at, ColorRow& to);

}  // namespace mien
