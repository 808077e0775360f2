#include "sdf/arrange/meeting.h"

#include <gtest/gtest.h>

#include "tests/support/random/random_piece.h"

namespace mien::test {
namespace {

double met(const OutlinePiece& left, const OutlinePiece& right) {
  return meeting(left, right, pair_at(left, right, std::max(left.y0, right.y0)),
                 pair_at(left, right, std::min(left.y1, right.y1)));
}

TEST(Meeting, StraightOnesMeetWhereTheyDo) {
  EXPECT_NEAR(met(piece_between({0, 0}, {8, 8}), piece_between({6, 0}, {2, 8})), 4, 1e-9);
}

TEST(Meeting, AnOrderThatIsWrongAtOnceChangesAtOnce) {
  EXPECT_EQ(met(piece_between({6, 0}, {9, 10}), piece_between({0, 1}, {5, 10})), 1);
}

TEST(Meeting, ThoseThatPartFirstMeetLater) {
  // From one point; the arc is right of the line until (5, 5) and ends left of it.
  const OutlinePiece line = piece_between({0, 0}, {10, 10}),
                     arc = piece_between({0, 0}, {8, 10}, 0.9, 0.3);
  const double y = met(line, arc);
  EXPECT_GT(y, 1);
  EXPECT_NEAR(pair_at(line, arc, y).gap(), 0, 1e-8);
  EXPECT_EQ(met(arc, piece_between({0, 0}, {1, 10})), 0);
}

TEST(Meeting, ThereTheGapIsNothing) {
  Random r(4);
  int pairs = 0;
  for (int i = 0; i < 40'000; ++i) {
    const OutlinePiece a = random_piece(r, 50), b = random_piece(r, 50);
    const double from = std::max(a.y0, b.y0), to = std::min(a.y1, b.y1);
    if (!(to > from) || !(pair_at(a, b, from).gap() > kTouch) || !(pair_at(a, b, to).gap() < 0.0))
      continue;
    ++pairs;
    const double y = met(a, b);
    ASSERT_GE(y, from) << i;
    ASSERT_LE(y, to) << i;
    const double h = 1e-8, above = pair_at(a, b, std::max(from, y - h)).gap(),
                 below = pair_at(a, b, std::min(to, y + h)).gap();
    ASSERT_TRUE(std::abs(pair_at(a, b, y).gap()) < 1e-6 || (above >= 0.0 && below <= 0.0)) << i;
  }
  EXPECT_GT(pairs, 2000);
}

}  // namespace
}  // namespace mien::test
