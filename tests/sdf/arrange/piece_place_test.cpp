#include "sdf/arrange/piece_place.h"

#include <gtest/gtest.h>

#include "tests/support/random/random_piece.h"
#include "tests/support/shapes/outline_sight.h"

namespace mien::test {
namespace {

TEST(PiecePlace, ItsPlaceAtAHeightIsThatFoundByHalving) {
  Random r(1);
  for (int i = 0; i < 2000; ++i) {
    const OutlinePiece p = random_piece(r, 100);
    for (int k = 0; k < 5; ++k) {
      const double y = r.between(p.y0, p.y1), x = mien::x_at(p, y), lo = test::x_at(p, y - 1e-9),
                   hi = test::x_at(p, y + 1e-9);
      ASSERT_GE(x, std::min(lo, hi) - 1e-9) << i;
      ASSERT_LE(x, std::max(lo, hi) + 1e-9) << i;
    }
  }
}

TEST(PiecePlace, ItIsAtItsEndsWhereItEndsAndBeyond) {
  Random r(2);
  for (int i = 0; i < 500; ++i) {
    const OutlinePiece p = random_piece(r, 100);
    for (const double beyond : {0.0, 1e-9, 7.0}) {
      EXPECT_EQ(mien::x_at(p, p.y0 - beyond), p.x0);
      EXPECT_EQ(mien::x_at(p, p.y1 + beyond), p.x1);
    }
    EXPECT_EQ(parameter_at(p, p.y0), 0.0);
    EXPECT_NEAR(parameter_at(p, p.y1), 1.0, 1e-12);
  }
}

TEST(PiecePlace, WideningIsTheGapsSlope) {
  Random r(3);
  int looked_at = 0;
  for (int i = 0; i < 2000; ++i) {
    const OutlinePiece e = random_piece(r, 100), f = random_piece(r, 100);
    const double top = std::max(e.y0, f.y0), bottom = std::min(e.y1, f.y1), h = 1e-4;
    if (bottom - top < 1.0) continue;
    const double y = r.between(top + 0.1, bottom - 0.1);
    const double slope = (mien::x_at(e, y + h) - mien::x_at(f, y + h) - mien::x_at(e, y - h) +
                          mien::x_at(f, y - h)) /
                         (2 * h);
    if (std::abs(slope) < 1e-2) continue;
    ASSERT_EQ(widening(f, e, pair_at(f, e, y)) > 0.0, slope > 0.0) << i;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 200);
}

TEST(PiecePlace, TurningSaysToWhichSideItBends) {
  Random r(4);
  for (int i = 0; i < 1000; ++i) {
    const OutlinePiece p = random_piece(r, 100);
    if (p.y1 - p.y0 < 1.0) continue;
    const double y = 0.5 * (p.y0 + p.y1);
    const double sag = 0.5 * (p.x0 + p.x1) - mien::x_at(p, y);  // > 0: convex
    if (std::abs(sag) < 1e-6) continue;
    ASSERT_EQ(turning(p) < 0.0, sag > 0.0) << i;
  }
}

}  // namespace
}  // namespace mien::test
