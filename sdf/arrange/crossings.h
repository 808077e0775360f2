#pragma once
// Where two monotone pieces change their order from left to right: nowhere, once or twice.

#include "sdf/arrange/sweep_piece.h"

#include <array>

namespace mien {

/// Heights at which two pieces have to swap, in order.
struct Crossings {
  std::array<double, 4> at;
  int count = 0;
  bool one_way = false;  ///< there is one, and the gap falls all the way there and beyond
  void add(double y) { at[std::size_t(count++)] = y; }
};

/// `left` lies left of `right` at the height y, says the sweep: that is believed, whatever their
/// numbers say there. What their numbers say where the first of them ends decides about one crossing;
/// where it is the same order, they may still cross there and back. An order that is wrong at y heals
/// at y.
Crossings crossings(const SweepPiece& left, const SweepPiece& right, double y);

/// What is closer than that touches [px]: too near for a wrong order to show (1e-6 of a pixel's area
/// per row), too far for roundings to reach (1e-10 at coordinates of a million).
inline constexpr double kTouch = 1e-6;

}  // namespace mien
