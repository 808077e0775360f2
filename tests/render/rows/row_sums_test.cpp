#include "render/rows/row_sums.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

OutlinePiece straight(glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 a = 0.5 * (to - from);
  return {from.x, from.y, a.x, a.y, 0, 0, to.x, to.y, 0, 0, 0, 1};
}

TEST(RowSums, AddUpAlongARowToTheAreaOfEveryPixel) {
  RowSums sums;
  sums.begin(16, 10, 64);
  sums.add(straight({2.25, 0}, {2.25, 2}), 0, 2, 0, {1, 0.5f, 0, 0}, -1, -1, 7);
  const Rgba* row = sums.sums(1);
  EXPECT_FLOAT_EQ(row[2].r, 0.75f);
  EXPECT_FLOAT_EQ(row[2].g, 0.375f);
  EXPECT_FLOAT_EQ(row[2].r + row[3].r, 1);
  EXPECT_EQ(sums.marks(1)[0], 0b100u);
  EXPECT_EQ(sums.hints(1)[2], 7);
  EXPECT_TRUE(sums.shares(1).empty());
  EXPECT_EQ(sums.marks(2)[0], 0u);
}

TEST(RowSums, CountWhatLiesLeftOfThePictureForAllOfIt) {
  RowSums sums;
  sums.begin(16, 10, 64);
  sums.add(straight({-5, 0.25}, {-5, 1}), 0.25, 1, 0, {1, 1, 1, 1}, -1, -1, 1);
  EXPECT_FLOAT_EQ(sums.sums(0)[0].r, 0.75f);
  EXPECT_FLOAT_EQ(sums.sums(0)[1].r, 0);
}

TEST(RowSums, GiveVariedLooksTheirAreaAndCentroid) {
  RowSums sums;
  sums.begin(16, 10, 64);
  sums.add(straight({4.5, 3}, {4.5, 4}), 3, 3.5, 0, {}, 2, 5, 5);  // half the row's height
  ASSERT_EQ(sums.shares(3).size(), 2u);
  const LookShare& left = sums.shares(3)[0];
  const LookShare& right = sums.shares(3)[1];
  EXPECT_EQ(left.look, 2);
  EXPECT_EQ(right.look, 5);
  EXPECT_FLOAT_EQ(right.area, 0.25f);
  EXPECT_FLOAT_EQ(right.mx / right.area, 0.25f);   // of the right half's middle
  EXPECT_FLOAT_EQ(right.my / right.area, -0.25f);  // and the upper half's
  EXPECT_FLOAT_EQ(left.area, -right.area);
  EXPECT_FLOAT_EQ(right.height, 0.5f);
  EXPECT_FLOAT_EQ(right.height_y, -0.125f);
}

TEST(RowSums, GiveTheMomentsOfTheArcNotOfItsChord) {
  RowSums sums;
  sums.begin(16, 10, 64);
  // x = 4.75 − t (1 − t), y = 3 + t.
  const OutlinePiece arc{4.75, 3, -0.5, 0.5, 1, 0, 4.75, 4, 0, 0, 0, 1};
  sums.add(arc, 3, 4, 0, {}, -1, 5, 5);
  ASSERT_EQ(sums.shares(3).size(), 1u);
  const LookShare& right = sums.shares(3)[0];
  EXPECT_FLOAT_EQ(right.area, 0.25f + 1.0f / 6);
  EXPECT_FLOAT_EQ(right.mx, 0.11875f);  // of the chord 0.09375
  EXPECT_NEAR(right.my, 0.0, 1e-7);
}

}  // namespace
}  // namespace mien
