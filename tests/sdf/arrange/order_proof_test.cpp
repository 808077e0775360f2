#include "sdf/arrange/order_proof.h"

#include <gtest/gtest.h>

#include "tests/support/random/random_piece.h"

namespace mien::test {
namespace {

struct Between {
  double from, to;
};

/// The heights both have.
Between heights_of(const OutlinePiece& a, const OutlinePiece& b) {
  return {std::max(a.y0, b.y0), std::min(a.y1, b.y1)};
}

bool in_order(const OutlinePiece& left, const OutlinePiece& right, double from, double to,
              double order = kOrder) {
  return !disorder(left, right, pair_at(left, right, from), pair_at(left, right, to), order);
}

/// What `left` is right of `right` by: the area, and the least gap.
struct Wrong {
  double area = 0, gap = HUGE_VAL;
};
Wrong wrong(const OutlinePiece& left, const OutlinePiece& right, Between y) {
  constexpr int kPlaces = 4000;
  Wrong w;
  for (int i = 0; i <= kPlaces; ++i) {
    const double at = y.from + (y.to - y.from) * i / kPlaces,
                 gap = x_at(right, at) - x_at(left, at);
    w.gap = std::min(w.gap, gap);
    w.area += std::max(0.0, -gap) * (y.to - y.from) / kPlaces;
  }
  return w;
}

TEST(OrderProof, WhatIsProvenIsTrue) {
  Random r(1);
  int held = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const double side = r.size(-1, 3);
    const OutlinePiece a = random_piece(r, side);
    OutlinePiece moved = r.chance(0.5) ? a : random_piece(r, side);
    if (r.chance(0.5)) {  // about as far as it can touch
      const Between y = heights_of(a, moved);
      if (!(y.to > y.from)) continue;
      const double shift = r.between(-2 * kOrder, 2 * kOrder) - wrong(a, moved, y).gap;
      moved.x0 += shift, moved.x1 += shift;
    }
    const OutlinePiece b = moved;
    const Between y = heights_of(a, b);
    if (!(y.to > y.from)) continue;
    const Wrong w = wrong(a, b, y);
    for (const double order : {kOrder, kOrder / 40}) {
      const bool holds = in_order(a, b, y.from, y.to, order);
      ++(holds ? held : refused);
      if (!holds) continue;
      ASSERT_TRUE(w.gap >= -order || w.area <= order) << i << ": " << w.gap << " " << w.area;
    }
  }
  EXPECT_GT(held, 400);
  EXPECT_GT(refused, 400);
}

TEST(OrderProof, NearlyAllThatTouchesInOrderIsProven) {  // the rest goes to the reference
  Random r(2);
  int pairs = 0, proven = 0;
  for (int i = 0; i < 3000; ++i) {
    const double side = r.size(-1, 3);
    const OutlinePiece a = random_piece(r, side);
    OutlinePiece moved = r.chance(0.5) ? a : random_piece(r, side);
    Between y = heights_of(a, moved);
    if (!(y.to > y.from)) continue;
    const double shift = -wrong(a, moved, y).gap;
    moved.x0 += shift, moved.x1 += shift;
    const OutlinePiece b = moved;
    ++pairs;
    proven += in_order(a, b, y.from, y.to);
  }
  EXPECT_GE(proven, 0.99 * pairs);
  EXPECT_GT(pairs, 1000);
}

TEST(OrderProof, CoincidentPiecesAreInEitherOrder) {
  Random r(3);
  for (int i = 0; i < 500; ++i) {
    const OutlinePiece a = random_piece(r, 100);
    EXPECT_TRUE(in_order(a, a, a.y0, a.y1));
  }
}

TEST(OrderProof, PiecesThatStartLevelAreProven) {
  // Both leave one vertex level, one bends down later.
  const OutlinePiece left = piece_between({10, 0}, {20, 10}, 0.5, 0.0);
  const OutlinePiece right = piece_between({10, 0}, {22, 10}, 0.7, 0.0);
  EXPECT_TRUE(in_order(left, right, 0, 10));
  EXPECT_FALSE(in_order(right, left, 0, 10));
}

}  // namespace
}  // namespace mien::test
