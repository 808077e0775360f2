#include "render/rows/row_sums.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

OutlinePiece straight(glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 a = 0.5 * (to - from);
  return {from.x, from.y, a.x, a.y, 0, 0, to.x, to.y};
}

TEST(RowSums, AddUpAlongARowToTheAreaOfEveryPixel) {
  RowSums sums;
  sums.begin(16, 10);
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
  sums.begin(16, 10);
  sums.add(straight({-5, 0.25}, {-5, 1}), 0.25, 1, 0, {1, 1, 1, 1}, -1, -1, 1);
  EXPECT_FLOAT_EQ(sums.sums(0)[0].r, 0.75f);
  EXPECT_FLOAT_EQ(sums.sums(0)[1].r, 0);
}

TEST(RowSums, KeepTheStretchesBesideVariedLooksByColumn) {
  RowSums sums;
  sums.begin(16, 10);
  sums.add(straight({4.5, 3}, {4.5, 4}), 3, 3.5, 0, {}, 2, 5, 5);  // half the row's height
  sums.add(straight({4.75, 3}, {4.75, 4}), 3.5, 4, 0, {}, -1, 2, 2);
  sums.add(straight({-4, 3}, {-4, 4}), 3, 4, 0, {}, -1, 2, 2);
  ASSERT_EQ(sums.shares(3).size(), 3u);
  EXPECT_EQ(sums.first_shares(3)[3], -1);
  const int latest = sums.first_shares(3)[4], first = sums.shares(3)[std::size_t(latest)].next;
  EXPECT_EQ(sums.shares(3)[std::size_t(latest)].left, -1);
  const LookShare& share = sums.shares(3)[std::size_t(first)];
  EXPECT_EQ(share.next, -1);
  EXPECT_EQ(share.left, 2);
  EXPECT_EQ(share.right, 5);
  EXPECT_FLOAT_EQ(share.area, 0.25f);
  EXPECT_FLOAT_EQ(share.rest, 0.5f);
  const PartStretch& stretch = sums.stretches(3)[std::size_t(first)];
  EXPECT_FLOAT_EQ(stretch.xm, 0.5f);
  EXPECT_FLOAT_EQ(stretch.yq, 0.5f);
  const int before = sums.first_shares(3)[0];  // left of the picture
  EXPECT_FLOAT_EQ(sums.shares(3)[std::size_t(before)].area, 1);
  EXPECT_EQ(sums.stretches(3)[std::size_t(before)].xp, 0);
  sums.forget_shares(3);
  EXPECT_TRUE(sums.shares(3).empty());
}

}  // namespace
}  // namespace mien
