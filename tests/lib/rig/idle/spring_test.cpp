#include "lib/rig/idle/spring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mien {
namespace {

TEST(Spring, FallsByItsOwnExponential) {
  for (double x = 0; x <= 8; x += 0.01) EXPECT_NEAR(fall_of(x) / std::exp(-x), 1, 1e-8);
}

/// Against the equation of motion, x″ = −ω² x − 2 d ω x′, by small steps.
TEST(Spring, MovesByItsEquation) {
  for (const Spring spring : {Spring{5.2, 0.6}, Spring{7, 0.7}, Spring{3, 0.2}}) {
    constexpr double kStep = 1e-5;
    double x = 1, v = 0, worst = 0, least = 1;
    for (double t = 0; t < spring.settling(); t += kStep) {
      worst = std::max(worst, std::abs(spring.left(t) - x));
      least = std::min(least, x);
      v -= kStep *
           (spring.frequency * spring.frequency * x + 2 * spring.damping * spring.frequency * v);
      x += kStep * v;
    }
    EXPECT_LT(worst, 2e-4);
    EXPECT_NEAR(-least,
                std::exp(-std::numbers::pi * spring.damping /
                         std::sqrt(1 - spring.damping * spring.damping)),
                1e-3)
        << "how far it overshoots";
  }
}

TEST(Spring, IsAtItsEndsExactly) {
  const Spring spring{5.2, 0.6};
  EXPECT_EQ(spring.left(0), 1);
  EXPECT_EQ(spring.left(-3), 1);
  EXPECT_EQ(spring.left(spring.settling()), 0);
  EXPECT_LT(std::abs(spring.left(spring.settling() - 1e-9)), 5e-4);
}

}  // namespace
}  // namespace mien
