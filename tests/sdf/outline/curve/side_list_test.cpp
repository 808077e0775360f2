#include "sdf/outline/curve/side_list.h"

#include <gtest/gtest.h>

namespace mien::test {

TEST(SideList, KeepsLoopsOneAfterTheOther) {
  SideList list;
  list.frame({{0, 0}, {9, 9}}, 0.01);
  list.begin({0, 0});
  list.line({4, 0});
  list.quad({4, 4}, {0, 4});
  list.close();
  list.begin({7, 7});
  list.close();
  ASSERT_EQ(list.loops(), 2u);
  ASSERT_EQ(list.loop(0).size(), 3u);
  EXPECT_EQ(list.loop(0)[0], (QuadBezier{{0, 0}, {2, 0}, {4, 0}}));
  EXPECT_EQ(list.loop(0)[1], (QuadBezier{{4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(list.loop(0)[2], (QuadBezier{{0, 4}, {0, 2}, {0, 0}}));
  ASSERT_EQ(list.loop(1).size(), 1u);  // a point
  EXPECT_EQ(list.loop(1)[0], (QuadBezier{{7, 7}, {7, 7}, {7, 7}}));
  list.frame({{0, 0}, {9, 9}}, 0.01);
  EXPECT_EQ(list.loops(), 0u);
}

TEST(SideList, SaysWhatLiesBeyondItsWindow) {
  SideList list;
  list.frame({{0, 0}, {9, 9}}, 0.25);
  EXPECT_EQ(list.tolerance(), 0.25);
  EXPECT_TRUE(list.beyond({{-5, 3}, {-1, 4}}));
  EXPECT_TRUE(list.beyond({{3, 10}, {4, 12}}));
  EXPECT_FALSE(list.beyond({{-5, 3}, {1, 4}}));
  EXPECT_FALSE(list.beyond({{-5, -5}, {20, 20}}));
}

}  // namespace mien::test
