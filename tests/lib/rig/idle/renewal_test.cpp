#include "lib/rig/idle/renewal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace mien {
namespace {

/// All moments within `seconds`, as they are found by asking at steps.
std::vector<double> moments_within(double seconds, double median, std::uint64_t stream) {
  std::set<double> times;
  for (double t = 0; t < seconds; t += 0.05)
    times.insert(moments_until(t, t, kLogNormal045, median, stream)[0].time);
  return {times.begin(), times.end()};
}

TEST(Renewal, DrawsGapsByItsLaw) {
  std::vector<double> gaps;
  for (std::uint64_t stream = 1; stream <= 20; ++stream) {
    const auto times = moments_within(600, 3, stream);
    for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back((times[i] - times[i - 1]) / 3);
  }
  std::sort(gaps.begin(), gaps.end());
  ASSERT_GT(gaps.size(), 3000u);
  for (std::size_t i = 1; i < 8; ++i)
    EXPECT_NEAR(gaps[i * gaps.size() / 8], kLogNormal045[i], 0.08) << i;
  EXPECT_GT(gaps.front(), 0.2);
  EXPECT_LT(gaps.back(), 4);
}

/// Whatever is asked, and in which order, it is the same chain.
TEST(Renewal, IsOneChain) {
  for (const double from : {0.0, -1000.0, 123456.0, 5e7}) {
    Moments last = moments_until(from, from - 20, kLogNormal055, 1, 7);
    for (double t = from; t < from + 60; t += 0.031) {
      const Moments now = moments_until(t, t - 20, kLogNormal055, 1, 7);
      ASSERT_GE(now.size(), 5u);
      ASSERT_LE(now[0].time, t);
      ASSERT_GT(now.next, t);
      for (std::size_t i = 0; i + 1 < now.size(); ++i) {
        ASSERT_EQ(now[i].before, now[i + 1].count);
        ASSERT_GT(now[i].time, now[i + 1].time);
      }
      if (now[0].count != last[0].count) {
        ASSERT_EQ(now[0].before, last[0].count) << "none is left out";
        ASSERT_NEAR(now[0].time, last.next, 1e-7);
      }
      last = now;
    }
  }
}

TEST(Renewal, KeepsTheOneBeforeAndThoseSince) {
  const Moments only = moments_until(50, 50, kLogNormal055, 1, 3);
  EXPECT_EQ(only.size(), 1u);
  const Moments all = moments_until(50, 40, kLogNormal055, 1, 3);
  EXPECT_EQ(all[0].time, only[0].time);
  EXPECT_GT(all[all.size() - 1].time, 40);
  EXPECT_LT(moments_until(50, -1e9, kLogNormal055, 1, 3).size(), Moments::kMost + 1);
}

}  // namespace
}  // namespace mien
