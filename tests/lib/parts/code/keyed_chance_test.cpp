#include "lib/parts/code/keyed_chance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

TEST(KeyedChance, SharesAreEvenlySpread) {
  double sum = 0, squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double u = KeyedChance(std::uint64_t(i)).share(7);
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.01);
  EXPECT_NEAR(squares / kCount, 1.0 / 3, 0.01);
}

TEST(KeyedChance, BellsHaveTheirSpread) {
  double sum = 0, squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double u = KeyedChance(std::uint64_t(i)).bell(7);
    ASSERT_LT(std::abs(u), 1.0);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / kCount), 1 / std::sqrt(12.0), 0.01);
}

TEST(KeyedChance, AnswersDoNotDependOnOtherQuestions) {
  const KeyedChance chance(42);
  const std::uint64_t alone = KeyedChance(42).bits(9);
  chance.bits(1), chance.bits(2), chance.bell(3);
  EXPECT_EQ(chance.bits(9), alone);
  EXPECT_NE(chance.bits(9), chance.bits(10));
  EXPECT_NE(chance.bits(9), chance.bits(9, 1));
}

}  // namespace
}  // namespace mien
