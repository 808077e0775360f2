// Steps that differ equally: against scales whose answer is known.

#include "tools/mien/data/equal_steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien::command {
namespace {

TEST(EqualSteps, OfAnEvenScaleAreEven) {
  const auto steps = equal_steps(-1, 3, 5, [](double a, double b) { return std::abs(a - b); });
  ASSERT_TRUE(steps);
  ASSERT_EQ(steps->size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], -1 + i, 4e-4);
  EXPECT_EQ(steps->front(), -1);
  EXPECT_EQ(steps->back(), 3);
}

TEST(EqualSteps, OfASquareAreRoots) {
  const auto steps =
      equal_steps(0, 1, 4, [](double a, double b) { return std::abs(a * a - b * b); });
  ASSERT_TRUE(steps);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], std::sqrt(i / 3.0), 2e-4);
}

TEST(EqualSteps, GoDownAsWell) {
  const auto steps = equal_steps(2, 1, 3, [](double a, double b) { return std::abs(a - b); });
  ASSERT_TRUE(steps);
  EXPECT_NEAR((*steps)[1], 1.5, 2e-4);
}

/// A way that bends back: neighbours are compared directly, not along the way.
TEST(EqualSteps, AreChordsNotArcs) {
  const auto on_circle = [](double a, double b) { return 2 * std::abs(std::sin((a - b) / 2)); };
  const auto steps = equal_steps(0, 3, 4, on_circle);
  ASSERT_TRUE(steps);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], i, 1e-3);
}

TEST(EqualSteps, NeedADifference) {
  EXPECT_FALSE(equal_steps(0, 1, 3, [](double, double) { return 0.0; }));
}

}  // namespace
}  // namespace mien::command
