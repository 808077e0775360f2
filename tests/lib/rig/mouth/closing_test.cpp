#include "lib/rig/mouth/closing.h"

#include <gtest/gtest.h>

#include <random>

namespace mien {
namespace {

TEST(Closing, MakesOneCurveOfAnyTwo) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1), share(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const LipPair lips{{number(random), number(random)}, {number(random), number(random)}};
    const LipPair shut = closed(lips, 1, share(random));
    ASSERT_EQ(shut.upper, shut.lower);
    ASSERT_EQ(closed(lips, 0, 0.32), lips);
  }
}

TEST(Closing, GoesEvenlyToTheSeam) {
  const LipPair lips{{0.1, 0.2}, {0.3, -0.8}};
  const LipPair half = closed(lips, 0.5, 0.25);
  EXPECT_NEAR(half.upper.x, 0.125, 1e-15);
  EXPECT_NEAR(half.upper.y, 0.075, 1e-15);
  EXPECT_NEAR(half.lower.x, 0.225, 1e-15);
  EXPECT_NEAR(half.lower.y, -0.425, 1e-15);
  EXPECT_EQ(closed(lips, 1, 0).upper, lips.upper);
  EXPECT_EQ(closed(lips, 1, 1).upper, lips.lower);
}

TEST(Closing, BringsCrossedLipsTogether) {
  const LipPair apart{{0, 0.1}, {0.2, -0.1}};
  EXPECT_EQ(uncrossed(apart), apart);
  const LipPair met = uncrossed({{0, -0.1}, {0.2, 0.1}});
  EXPECT_EQ(met.upper, met.lower);
  EXPECT_EQ(met.upper, glm::dvec2(0.1, 0));
}

}  // namespace
}  // namespace mien
