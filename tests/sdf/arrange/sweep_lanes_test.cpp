#include "sdf/arrange/sweep_lanes.h"

#include <gtest/gtest.h>

#include "sdf/arrange/piece_place.h"
#include "tests/support/random/random_piece.h"

namespace mien::test {
namespace {

/// Lanes of as many pieces that pass both heights.
SweepLanes lanes_between(Random& r, std::size_t count, double from, double to,
                         std::vector<OutlinePiece>& pieces) {
  SweepLanes lanes;
  pieces.clear();
  while (pieces.size() < count) {
    const OutlinePiece p = random_piece(r, 100);
    if (p.y0 > from || p.y1 < to) continue;
    const std::size_t lane = pieces.size();
    lanes.room_for(++lanes.count);
    lanes.load(lane, p);
    lanes.t[lane] = parameter_at(p, from), lanes.x[lane] = x_of(p, lanes.t[lane]);
    pieces.push_back(p);
  }
  place(lanes, from, to);
  return lanes;
}

TEST(SweepLanes, PlacesAreThoseOfPiecesToTheBit) {
  Random r(1);
  std::vector<OutlinePiece> pieces;
  for (int i = 0; i < 200; ++i) {
    const double from = r.between(30, 60), to = from + r.size(-3, 1);
    const SweepLanes lanes = lanes_between(r, std::size_t(1 + i % 19), from, to, pieces);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      ASSERT_EQ(lanes.next_t[k], parameter_at(pieces[k], to));
      ASSERT_EQ(lanes.next_x[k], x_of(pieces[k], lanes.next_t[k]));
    }
  }
}

TEST(SweepLanes, ChainsStayWithinTheirExtentsAndSags) {
  Random r(2);
  std::vector<OutlinePiece> pieces;
  double least_used = HUGE_VAL;
  for (int i = 0; i < 300; ++i) {
    const double from = r.between(30, 60), to = from + r.size(-3, 1.4);
    const SweepLanes lanes = lanes_between(r, 7, from, to, pieces);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      double left = 0, right = 0;
      for (int n = 0; n <= 40; ++n) {
        const double share = n / 40.0, x = mien::x_at(pieces[k], from + (to - from) * share),
                     chord = lanes.x[k] + (lanes.next_x[k] - lanes.x[k]) * share;
        ASSERT_GE(x, lanes.low[k] - 1e-9);
        ASSERT_LE(x, lanes.high[k] + 1e-9);
        left = std::max(left, chord - x), right = std::max(right, x - chord);
      }
      ASSERT_LE(left, lanes.sag_left[k] + 1e-9);
      ASSERT_LE(right, lanes.sag_right[k] + 1e-9);
      const double sag = std::max(lanes.sag_left[k], lanes.sag_right[k]);
      if (sag > 1e-3) least_used = std::min(least_used, std::max(left, right) / sag);
    }
  }
  EXPECT_GT(least_used, 0.4);  // no sag is much more than it must be
}

}  // namespace
}  // namespace mien::test
