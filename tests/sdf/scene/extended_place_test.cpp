#include "sdf/scene/extended_place.h"

#include <gtest/gtest.h>

#include <limits>

namespace mien::test {
namespace {

TEST(ExtendedPlace, IsBetweenTheStops) {
  EXPECT_EQ(extended_place(Extend::repeat, 1, 3, 1.5), 1.5);
  EXPECT_EQ(extended_place(Extend::repeat, 1, 3, 3.5), 1.5);
  EXPECT_EQ(extended_place(Extend::repeat, 1, 3, -0.5), 1.5);
  EXPECT_EQ(extended_place(Extend::reflect, 1, 3, 3.5), 2.5);
  EXPECT_EQ(extended_place(Extend::reflect, 1, 3, 5.5), 1.5);
  EXPECT_EQ(extended_place(Extend::reflect, 1, 3, 0.5), 1.5);
}

TEST(ExtendedPlace, StaysWhereNothingRepeats) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(extended_place(Extend::pad, 1, 3, 7), 7);
  EXPECT_EQ(extended_place(Extend::repeat, 2, 2, 7), 7);
  EXPECT_EQ(extended_place(Extend::reflect, 1, 3, -kInfinite), -kInfinite);
}

}  // namespace
}  // namespace mien::test
