#pragma once
// Where two monotone pieces change their order from left to right: nowhere, once or twice.

#include "sdf/arrange/sweep_piece.h"

#include <array>

namespace mien {

/// Heights at which two pieces have to swap, in order.
struct Crossings {
  std::array<double, 4> at;
  int count = 0;
  bool one_way = false;  ///< there is one, and the gap falls all along
  void add(double y) { at[std::size_t(count++)] = y; }
};

/// The sweep says that `left` lies left of `right` at the height y, and is believed even if their coordinates
/// disagree there. Their coordinates where the first of them ends decide whether they cross once; if the order
/// there is the same, they may still cross there and back. An order that is wrong at y is put right at y.
Crossings crossings(const SweepPiece& left, const SweepPiece& right, double y);

/// Pieces closer than this touch [px]: too close for a wrong order to show (1e-6 of a pixel's area per row), but
/// far above rounding (1e-10 at coordinates of a million).
inline constexpr double kTouch = 1e-6;

}  // namespace mien
