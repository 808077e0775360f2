#pragma once
// Active chains side by side: where each is at the upper and at the lower height of a step, and how far it strays in
// between.

#include "sdf/outline/outlines.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mien {

struct SweepLanes {
  std::size_t count = 0;  ///< lanes that were ever used at once; some of them may be free
  /// The piece at the lower height: its numbers, its end and how it turns (piece_place.h).
  std::vector<double> x0, y0, ax, ay, bx, by, bottom, turning;
  /// At the upper height.
  std::vector<double> x, t;
  /// At the lower height; the least and greatest x in between; and how far it leaves its chord to the left and to the
  /// right.
  std::vector<double> next_x, next_t, low, high, sag_left, sag_right;

  static constexpr std::size_t kSpare =
      8;  ///< numbers beyond the last lane that may be read and written
  void room_for(std::size_t lanes);
  void load(std::size_t lane, const OutlinePiece& piece);
  std::size_t bytes() const { return 16 * x.capacity() * sizeof(double); }
};

/// Finds what belongs to the lower height `to`, as if each chain were one piece all the way from the height `from`.
void place(SweepLanes& lanes, double from, double to);

}  // namespace mien
