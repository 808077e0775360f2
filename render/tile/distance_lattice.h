#pragma once
// The distances of an area all over a block of 8 × 8 pixels: at the pixels' corners and centres.
//
// Where a distance is smooth it is known from few of its values. The block's 25 nodes (0, 1, 4, 7, 8
// pixels from its begin, each way) carry a polynomial of degree 4 × 4; eight more places, in the widest gaps
// between the nodes, say whether that is the distance. If they all agree within kTolerance the
// polynomial stands for all 81 corners and 64 centres: 33 distances instead of 145. If one doesn't (a
// crease, a tight bend), all corners are asked for, and centres when they are wanted.
//
// Error. At the eight places at most kTolerance, elsewhere about that, but for kinks. A line along which a
// distance has a kink, wherever it crosses the block, has one of the block's corners on its far side; that node
// counts for 6 % of what it is off by at the nearest of the eight places. So a kink that stays unseen is off
// by less than kUnseen. A relief of slope 1 so errs by a quarter of a level of 255 at the worst, beside a kink.
//
// Nodes are symmetrical and sums are taken in mirrored pairs: mirrored pictures have the same bits.

#include <mien/render/tile/area_distance.h>

#include <array>

namespace mien {

class DistanceLattice {
 public:
  static constexpr int kBlock = 8;            ///< pixels, each way
  static constexpr double kTolerance = 2e-5;  ///< [pixels]
  static constexpr double kUnseen = 1e-3;     ///< [pixels]
  using Corners = std::array<double, 4>;      ///< 00, 10, 01, 11

  /// Of the block that begins at `begin`; nothing is done if it is that already.
  void fill(const AreaDistance& area, glm::dvec2 begin);

  Corners corners(int column, int row) const;
  double center(const AreaDistance& area, int column, int row) const;
  bool smooth() const { return smooth_; }

 private:
  static constexpr int kPlaces = 2 * kBlock + 1;  ///< half a pixel apart
  bool is_smooth(const AreaDistance& area) const;
  double at(int column, int row) const { return d_[std::size_t(row * kPlaces + column)]; }

  glm::dvec2 begin_{0.0};
  bool filled_ = false, smooth_ = false;
  std::array<double, std::size_t(kPlaces* kPlaces)> d_;
};

}  // namespace mien
