#include "lib/rig/eye/gaze.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace mien {
namespace {

constexpr glm::dvec3 kLeft{0.2, 0.1, 0}, kRight{-0.2, 0.1, 0};
constexpr glm::dvec2 kReach{0.15, 0.12};
constexpr double kRadius = 0.2;

glm::dvec2 shift(glm::dvec3 eye, glm::dvec3 target) {
  return gaze_shift(eye, kRadius, kReach, target);
}

TEST(Gaze, ConvergesOnNearTargetsAndIsParallelAtInfinity_E8) {
  double before = 0;
  for (const double z : {100.0, 10.0, 3.0, 1.0, 0.6}) {
    const double vergence = shift(kRight, {0, 0.1, z}).x - shift(kLeft, {0, 0.1, z}).x;
    EXPECT_GT(vergence, before) << z;  // pupils come together
    before = vergence;
    EXPECT_EQ(shift(kRight, {0, 0.1, z}).x, -shift(kLeft, {0, 0.1, z}).x);
  }
  for (const glm::dvec3 way : {glm::dvec3{0, 0, 1}, {0.3, -0.2, 1}, {1, 1, 0.2}})
    EXPECT_LT(glm::length(shift(kLeft, 1e9 * way) - shift(kRight, 1e9 * way)), 1e-9);
  EXPECT_EQ(shift(kLeft, {0.2, 0.1, 1e9}), glm::dvec2(0));
}

/// The axis through centre and iris passes through the target, as long as the eye reaches it.
TEST(Gaze, PointsAtItsTarget_E8) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit{-1, 1};
  int reached = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 target{2 * unit(random), 2 * unit(random), 3 + 2 * unit(random)};
    const glm::dvec2 s = shift(kLeft, target);
    const double far = std::hypot(s.x / kReach.x, s.y / kReach.y);
    EXPECT_LE(far, 1 + 1e-15);
    const glm::dvec3 wanted = glm::normalize(target - kLeft), got = gaze_axis(s, kRadius);
    EXPECT_NEAR(glm::length(got), 1, 1e-15);
    if (far < 0.999) {
      EXPECT_LT(glm::length(got - wanted), 1e-14);
      ++reached;
    } else {
      EXPECT_NEAR(s.x * wanted.y, s.y * wanted.x, 1e-15);  // clamped towards the rest
    }
  }
  EXPECT_GT(reached, 500);
}

TEST(Gaze, LooksAsideForWhatIsBehindAndIsTotal_E8) {
  EXPECT_NEAR(shift(kLeft, {5.2, 0.1, -3}).x, kReach.x, 1e-15);
  EXPECT_NEAR(shift(kLeft, {0.2, -5, 0}).y, -kReach.y, 1e-15);
  EXPECT_EQ(shift(kLeft, kLeft), glm::dvec2(0));
  EXPECT_EQ(shift(kLeft, kLeft - glm::dvec3(0, 0, 1)), glm::dvec2(0));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(shift(kLeft, {kNan, 0, 1}), glm::dvec2(0));
  EXPECT_EQ(gaze_shift(kLeft, kRadius, {0, 0}, {5, 5, 1}), glm::dvec2(0));
  EXPECT_LE(glm::length(gaze_shift(kLeft, kRadius, {9, 9}, {5, 5, 0})), kRadius * (1 + 1e-15));
  EXPECT_EQ(gaze_axis({0, 0}, 0), glm::dvec3(0, 0, 1));
  EXPECT_EQ(gaze_axis({3, 4}, 1), glm::dvec3(0.6, 0.8, 0));
}

TEST(Gaze, KeepsEveryBitWithinReach) {
  std::mt19937 random{2};
  std::uniform_real_distribution<double> unit{-0.1, 0.1};
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 s{unit(random), 0.5 * unit(random)};
    EXPECT_EQ(within_reach(s, kReach), s);
  }
}

}  // namespace
}  // namespace mien
