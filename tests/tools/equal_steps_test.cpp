// Steps that differ equally: against scales whose answer is known.

#include "tools/mien/data/equal_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mien::command {
namespace {

/// A ruler that asks about two places at a time, and counts for how many places it is asked.
Ruler by(const std::function<double(double, double)>& difference, int* asked = nullptr) {
  return [=](const std::vector<double>& places) {
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      steps.push_back(difference(places[i], places[i + 1]));
    if (asked) *asked += int(places.size());
    return steps;
  };
}

TEST(EqualSteps, OfAnEvenScaleAreEven) {
  const auto steps = equal_steps(-1, 3, 5, by([](double a, double b) { return std::abs(a - b); }));
  ASSERT_TRUE(steps);
  ASSERT_EQ(steps->size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], -1 + i, 4e-4);
  EXPECT_EQ(steps->front(), -1);
  EXPECT_EQ(steps->back(), 3);
}

TEST(EqualSteps, OfASquareAreRoots) {
  const auto steps =
      equal_steps(0, 1, 4, by([](double a, double b) { return std::abs(a * a - b * b); }));
  ASSERT_TRUE(steps);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], std::sqrt(i / 3.0), 2e-4);
}

TEST(EqualSteps, GoDownAsWell) {
  const auto steps = equal_steps(2, 1, 3, by([](double a, double b) { return std::abs(a - b); }));
  ASSERT_TRUE(steps);
  EXPECT_NEAR((*steps)[1], 1.5, 2e-4);
}

/// A way that bends back: neighbours are compared directly, not along the way.
TEST(EqualSteps, AreChordsNotArcs) {
  const auto on_circle = [](double a, double b) { return 2 * std::abs(std::sin((a - b) / 2)); };
  const auto steps = equal_steps(0, 3, 4, by(on_circle));
  ASSERT_TRUE(steps);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*steps)[std::size_t(i)], i, 1e-3);
}

/// Pictures of moving edges differ by the root of the way they go, and by more where there are more edges.
TEST(EqualSteps, AreEvenWhereDifferencesDoNotAdd) {
  const auto on_screen = [](double a, double b) {
    return std::sqrt(std::abs(a * a * a - b * b * b));
  };
  int asked = 0;
  const auto steps = equal_steps(0.2, 1, 20, by(on_screen, &asked));
  ASSERT_TRUE(steps);
  std::vector<double> differences;
  for (int i = 0; i < 19; ++i)
    differences.push_back(on_screen((*steps)[std::size_t(i)], (*steps)[std::size_t(i) + 1]));
  const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
  EXPECT_LT(*most / *least, 1.03);
  EXPECT_LT(asked, 65 + 9 * 20);
}

TEST(EqualSteps, HoldBeyondJumpsAndRests) {
  const auto jump = [](double a, double b) { return (a < 0.5) != (b < 0.5) ? 1.0 : 0.0; };
  const auto steps = equal_steps(0, 1, 3, by(jump));
  ASSERT_TRUE(steps);
  EXPECT_EQ(steps->front(), 0);
  EXPECT_EQ(steps->back(), 1);
  EXPECT_TRUE(std::is_sorted(steps->begin(), steps->end()));
}

TEST(EqualSteps, NeedADifference) {
  EXPECT_FALSE(equal_steps(0, 1, 3, by([](double, double) { return 0.0; })));
}

}  // namespace
}  // namespace mien::command
