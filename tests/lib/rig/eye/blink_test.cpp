#include "lib/rig/eye/blink.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace mien {
namespace {

TEST(Blink, MeetsWhereTheBiasSays_C5) {
  for (const double meet : {0.0, 0.3, 0.9, 1.0}) {
    EXPECT_EQ(meeting_share(-1, meet), 1);
    EXPECT_EQ(meeting_share(0, meet), meet);
    EXPECT_EQ(meeting_share(1, meet), 0);
    for (double bias = -1; bias < 1; bias += 0.1) {
      EXPECT_GE(meeting_share(bias, meet), meeting_share(bias + 0.1, meet));
    }
  }
  const LidPair lids{{0.1, 0.3}, {0.2, -0.2}};
  EXPECT_EQ(blinked(lids, 1, 1), (LidPair{lids.lower, lids.lower}));
  EXPECT_EQ(blinked(lids, 1, 0), (LidPair{lids.upper, lids.upper}));
}

/// From any pose, for any bias: at 1 both lids are one curve, bit for bit; at 0 nothing moved; and
/// on the way the gap only shrinks.
TEST(Blink, ShutsEveryEyeForEveryBias_C5) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit{-1, 1};
  for (int i = 0; i < 1000; ++i) {
    const LidPair lids{{unit(random), unit(random)}, {unit(random), unit(random)}};
    const double share = meeting_share(unit(random), 0.5 + 0.5 * unit(random));
    const LidPair shut = blinked(lids, 1, share);
    EXPECT_EQ(shut.upper, shut.lower);
    EXPECT_EQ(blinked(lids, 0, share), lids);
    double before = glm::length(lids.upper - lids.lower) + 1e-15;
    for (double w = 0.01; w < 1; w += 0.01) {
      const LidPair now = blinked(lids, w, share);
      EXPECT_LT(glm::length(now.upper - now.lower), before);
      before = glm::length(now.upper - now.lower);
    }
  }
}

TEST(Blink, LidsThatPosesCrossAreKeptFromCrossing) {
  const glm::dvec2 up{0, 1};
  const LidPair open{{0.1, 0.3}, {0.2, -0.2}}, crossed{{0.1, -0.1}, {0.2, 0.1}};
  EXPECT_EQ(uncrossed(open, up, 0.9), open);
  const LidPair kept = uncrossed(crossed, up, 0.9);
  EXPECT_EQ(kept.upper, kept.lower);
  EXPECT_LT(glm::length(kept.upper - (0.1 * crossed.upper + 0.9 * crossed.lower)), 1e-15);
  // Nothing jumps where lids begin to cross.
  const auto at = [&](double gap) { return uncrossed({{0.1, gap}, {0.2, 0}}, up, 0.5); };
  for (double gap = -0.05; gap < 0.05; gap += 1e-4) {
    EXPECT_LT(glm::length(at(gap + 1e-4).upper - at(gap).upper), 1e-3) << gap;
    EXPECT_LT(glm::length(at(gap + 1e-4).lower - at(gap).lower), 1e-3) << gap;
    EXPECT_GE(glm::dot(at(gap).upper - at(gap).lower, up), 0) << gap;
  }
}

/// Each lid gives way by its share: the lower one moves little where they meet near it, and the place where they would
/// meet stays.
TEST(Blink, LidsKeptFromSlidingGiveWayByTheirShares) {
  const glm::dvec2 up{0.6, 0.8}, along{0.8, -0.6};
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
    for (const double slant : {-0.3, 0.3}) {
      const LidPair slid{{0.1, 0.2}, glm::dvec2{0.1, 0.2} - 0.02 * up - slant * along};
      const LidPair kept = uncrossed(slid, up, share);
      const double given = std::abs(slant) - kMostSlant * 0.02;
      EXPECT_NEAR(glm::length(kept.upper - slid.upper), share * given, 1e-15) << share;
      EXPECT_NEAR(glm::length(kept.lower - slid.lower), (1 - share) * given, 1e-15) << share;
      const glm::dvec2 gap = kept.upper - kept.lower;
      EXPECT_NEAR(glm::dot(gap, up), 0.02, 1e-15);
      EXPECT_NEAR(glm::dot(gap, along), std::copysign(kMostSlant * 0.02, slant), 1e-15);
    }
}

}  // namespace
}  // namespace mien
