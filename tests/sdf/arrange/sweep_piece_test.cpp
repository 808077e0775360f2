#include "sdf/arrange/sweep_piece.h"

#include <gtest/gtest.h>

#include "tests/support/outline_sight.h"
#include "tests/support/random_piece.h"

namespace mien::test {
namespace {

TEST(SweepPiece, ItsPlaceAtAHeightIsThatFoundByHalving) {
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

TEST(SweepPiece, ItIsAtItsEndsWhereItEndsAndBeyond) {
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

TEST(SweepPiece, ALevelOneIsMetWhereTheSweepIs) {
  const OutlinePiece p = piece_between({2, 5}, {8, 5});
  EXPECT_EQ(x_there(p, 5, 3), 3);
  EXPECT_EQ(x_there(p, 5, 1), 2);
  EXPECT_EQ(x_there(p, 5, 9), 8);
  EXPECT_EQ(parameter_at(p, 5), 0.0);
}

TEST(SweepPiece, OfTwoPlacesAtOneHeightTheLeftOneComesFirst) {
  EXPECT_TRUE(mien::before(5, 1, 0, 2));
  EXPECT_TRUE(mien::before(0, 2, 5, 2));
  EXPECT_FALSE(mien::before(5, 2, 5, 2));
  EXPECT_FALSE(mien::before(0, 2, 5, 1));
}

TEST(SweepPiece, PartingIsTheGapsSlope) {
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
    ASSERT_EQ(parting(e, f, y) > 0.0, slope > 0.0) << i;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 200);
}

TEST(SweepPiece, TurningSaysToWhichSideItBends) {
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

TEST(SweepPiece, ItStaysWithinItsReachAndItsBulge) {
  Random r(5);
  for (int i = 0; i < 2000; ++i) {
    const SweepPiece p = sweep_piece(random_piece(r, 1e5));
    for (int k = 0; k <= 20; ++k) {
      const double y = p.y0 + (p.y1 - p.y0) * k / 20, x = mien::x_at(p, y);
      ASSERT_LE(double(p.lowest_x), x);
      ASSERT_GE(double(p.highest_x), x);
      ASSERT_LE(x - chord_at(p, y), p.right_bulge) << i;
      ASSERT_LE(chord_at(p, y) - x, p.left_bulge) << i;
    }
  }
}

TEST(SweepPiece, TheBulgeIsNoLargerThanItMustBe) {
  Random r(6);
  for (int i = 0; i < 300; ++i) {
    const SweepPiece p = sweep_piece(random_piece(r, 100));
    double left = 0.0, right = 0.0;
    for (int k = 1; k < 1000; ++k) {
      const double y = p.y0 + (p.y1 - p.y0) * k / 1000, out = mien::x_at(p, y) - chord_at(p, y);
      left = std::max(left, -out), right = std::max(right, out);
    }
    ASSERT_LE(p.left_bulge, 1.05 * left + 1e-3) << i;
    ASSERT_LE(p.right_bulge, 1.05 * right + 1e-3) << i;
  }
}

TEST(SweepPiece, NoGapIsLessThanByChordsOrTangents) {
  Random r(8);
  int apart = 0, apart_by_tangents = 0;
  for (int i = 0; i < 3000; ++i) {
    const SweepPiece a = sweep_piece(random_piece(r, 100)), b = sweep_piece(random_piece(r, 100));
    const double from = std::max(a.y0, b.y0), to = std::min(a.y1, b.y1);
    if (!(to > from)) continue;
    const double chords = chord_gap(a, b, from, to), tangents = tangent_gap(a, b, from, to),
                 least = std::max(chords, tangents);
    apart += chords > 0.0;
    apart_by_tangents += tangents > chords && tangents > 0.0;
    for (int k = 0; k <= 50; ++k) {
      const double y = from + (to - from) * k / 50;
      ASSERT_GE(mien::x_at(b, y) - mien::x_at(a, y), least - 1e-9) << i;
    }
  }
  EXPECT_GT(apart, 300);
  EXPECT_GT(apart_by_tangents, 100);
}

}  // namespace
}  // namespace mien::test
