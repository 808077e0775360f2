#include "sdf/arrange/crossings.h"

#include <gtest/gtest.h>

#include "tests/support/random_piece.h"

namespace mien::test {
namespace {

Crossings crossings_of(const OutlinePiece& left, const OutlinePiece& right) {
  return crossings(sweep_piece(left), sweep_piece(right), std::max(left.y0, right.y0));
}

/// The largest gap [px] that the order told by the crossings has the wrong way round, away from
/// them.
double wrong_gap(const OutlinePiece& left, const OutlinePiece& right, const Crossings& found) {
  constexpr int kPlaces = 500;
  const double from = std::max(left.y0, right.y0), to = std::min(left.y1, right.y1);
  double most = 0.0;
  for (int i = 1; i < kPlaces; ++i) {
    const double y = from + (to - from) * i / kPlaces;
    int passed = 0;
    for (int k = 0; k < found.count; ++k) passed += found.at[std::size_t(k)] <= y;
    const double gap = x_at(right, y) - x_at(left, y);
    most = std::max(most, passed % 2 ? gap : -gap);
  }
  return most;
}

TEST(Crossings, SidesApartHaveNone) {
  EXPECT_EQ(crossings_of(piece_between({0, 0}, {5, 10}), piece_between({6, 0}, {9, 10})).count, 0);
  EXPECT_EQ(crossings_of(piece_between({0, 0}, {5, 10}), piece_between({1, 0}, {6, 10})).count, 0);
}

TEST(Crossings, AnOrderThatIsWrongHealsAtOnce) {
  const Crossings found =
      crossings_of(piece_between({6, 0}, {9, 10}), piece_between({0, 1}, {5, 10}));
  ASSERT_EQ(found.count, 1);
  EXPECT_EQ(found.at[0], 1);
}

TEST(Crossings, StraightOnesCrossWhereTheyDo) {
  const Crossings found =
      crossings_of(piece_between({0, 0}, {8, 8}), piece_between({6, 0}, {2, 8}));
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.at[0], 4, 1e-9);
}

TEST(Crossings, ThereAndBackAreTwo) {
  // x = 1 beside an arc from (2, 0) to (2, 10) that reaches x = 0: as two pieces, each once …
  const OutlinePiece down = piece_between({2, 0}, {0, 5}, 1.0, 0.5),
                     line = piece_between({1, 0}, {1, 10});
  EXPECT_EQ(crossings_of(line, down).count, 1);
  // … and a chord from end to end of a quarter arc's pair: inside at both ends, outside between.
  const OutlinePiece arc = piece_between({10, 0}, {0, 10}, 0.0, 1.0),
                     chord = piece_between({9.5, 0}, {-0.5, 10});
  EXPECT_EQ(crossings_of(chord, arc).count, 0);
  const OutlinePiece hollow = piece_between({10, 0}, {0, 10}, 1.0, 0.0);
  const Crossings found = crossings_of(chord, hollow);
  ASSERT_EQ(found.count, 2);
  EXPECT_LT(found.at[0], found.at[1]);
  EXPECT_LT(wrong_gap(chord, hollow, found), 1e-6);
}

TEST(Crossings, ASharedStartIsNoCrossing) {
  Random r(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 start = r.point(0, 50);
    const OutlinePiece a = piece_between(start, start + glm::dvec2{r.between(-9, 9), 5.0}),
                       b = piece_between(start, start + glm::dvec2{r.between(-9, 9), 5.0});
    const bool a_left = a.x1 < b.x1;
    EXPECT_EQ(crossings_of(a_left ? a : b, a_left ? b : a).count, 0) << i;
    const Crossings wrong = crossings_of(a_left ? b : a, a_left ? a : b);
    ASSERT_EQ(wrong.count, 1) << i;
    EXPECT_NEAR(wrong.at[0], start.y, 1e-3) << i;
  }
}

TEST(Crossings, ASharedEndIsNoCrossing) {
  Random r(2);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 end = r.point(20, 50);
    const OutlinePiece a = piece_between(end - glm::dvec2{r.between(-9, 9), 5.0}, end),
                       b = piece_between(end - glm::dvec2{r.between(-9, 9), 5.0}, end);
    const bool a_left = a.x0 < b.x0;
    EXPECT_EQ(crossings_of(a_left ? a : b, a_left ? b : a).count, 0) << i;
  }
}

TEST(Crossings, CoincidentPiecesKeepTheOrderTheyHave) {
  Random r(3);
  for (int i = 0; i < 300; ++i) {
    const OutlinePiece p = random_piece(r, 50);
    EXPECT_EQ(crossings_of(p, p).count, 0);
  }
}

TEST(Crossings, LevelPiecesAreMetWhereTheSweepIs) {
  const OutlinePiece level = piece_between({2, 5}, {8, 5}), down = piece_between({5, 0}, {5, 9});
  // The sweep comes along the level piece from its left end: its right end lies beyond the other.
  EXPECT_EQ(crossings(sweep_piece(level), sweep_piece(down), 5).count, 1);
  EXPECT_EQ(crossings(sweep_piece(level), sweep_piece(piece_between({9, 0}, {9, 9})), 5).count, 0);
}

/// The order between the crossings is the true one, in all but a few of many random pairs: those that
/// cross three times at once, which the sweep's certificate has to see.
TEST(Crossings, TheOrderBetweenThemIsTrue) {
  Random r(4);
  int pairs = 0, missed = 0;
  for (int i = 0; i < 40'000; ++i) {
    OutlinePiece a = random_piece(r, 50), b = random_piece(r, 50);
    const double from = std::max(a.y0, b.y0), to = std::min(a.y1, b.y1);
    if (!(to > from)) continue;
    if (x_at(a, from) > x_at(b, from)) std::swap(a, b);
    ++pairs;
    const Crossings found = crossings_of(a, b);
    for (int k = 0; k < found.count; ++k) {
      ASSERT_GE(found.at[std::size_t(k)], from) << i;
      ASSERT_LE(found.at[std::size_t(k)], to) << i;
      if (k > 0) {
        ASSERT_LE(found.at[std::size_t(k) - 1], found.at[std::size_t(k)] + 1e-9) << i;
      }
    }
    missed += wrong_gap(a, b, found) > 1e-4;
  }
  EXPECT_GT(pairs, 10'000);
  EXPECT_LE(missed, pairs / 1000);
  RecordProperty("missed", missed);
}

}  // namespace
}  // namespace mien::test
