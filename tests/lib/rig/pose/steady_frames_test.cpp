#include <mien/steady_frames.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

constexpr double kFrame = 1 / 30.0;

const Face& toon() {
  static const Face face = test::sample_face("faces/toon");
  return face;
}

std::vector<Setting> frame(double jaw) {
  return test::pose_of(toon(), {fmt::format("arkit.jawOpen={}", jaw)}).settings;
}

double jaw_of(const std::vector<Setting>& settings) {
  return settings[0].values[0];
}

TEST(SteadyFrames, AreQuietWhereAFaceRests) {
  std::mt19937 bits(1);
  SteadyFrames steady;
  double seen = 0, left = 0;
  for (int i = 0; i < 600; ++i) {
    const double noise = 0.02 * (double(bits()) * 0x1p-32 - 0.5);
    const double value = jaw_of(steady.steadied(toon(), frame(0.5 + noise), i * kFrame));
    if (i < 60) continue;
    seen += noise * noise, left += (value - 0.5) * (value - 0.5);
  }
  EXPECT_LT(left, 0.15 * seen) << "a hundredth of noise, of which little is left";
}

TEST(SteadyFrames, AreNotLateWhereAFaceMoves) {
  SteadyFrames steady, slow({.cutoff = 1, .beta = 0});
  double at = 0, late = 0;
  for (int i = 0; i <= 33; ++i) {
    const double seen = i < 30 ? 0 : 1;  // a mouth that opens within a frame
    at = jaw_of(steady.steadied(toon(), frame(seen), i * kFrame));
    late = jaw_of(slow.steadied(toon(), frame(seen), i * kFrame));
  }
  EXPECT_GT(at, 0.9) << "four frames later";
  EXPECT_LT(late, 0.7);
}

/// By hand: α(1 Hz) at 30 frames a second is 0.1731 for the speed; from 0 to 0.1 it is 3 a second, of which 0.519.
TEST(SteadyFrames, FollowTheirFormula) {
  SteadyFrames steady({.cutoff = 1.5, .beta = 2});
  EXPECT_EQ(jaw_of(steady.steadied(toon(), frame(0), 5)), 0);
  const auto alpha = [](double f) { return 1 / (1 + 1 / (2 * M_PI * f * kFrame)); };
  const double speed = alpha(1) * 3;
  EXPECT_NEAR(speed, 0.519, 1e-3);
  EXPECT_NEAR(jaw_of(steady.steadied(toon(), frame(0.1), 5 + kFrame)), alpha(1.5 + 2 * speed) * 0.1,
              1e-9);
}

TEST(SteadyFrames, BeginAgainAfterAPause) {
  for (const double next : {-1.0, 1.0, 2.5, double(NAN), double(INFINITY)}) {
    SteadyFrames steady;
    EXPECT_EQ(jaw_of(steady.steadied(toon(), frame(0), 1)), 0);
    EXPECT_EQ(jaw_of(steady.steadied(toon(), frame(1), next)), 1) << next;
  }
  SteadyFrames odd({.cutoff = -1, .beta = NAN}), plain;
  for (const double time : {0.0, 0.1, 0.2})
    EXPECT_EQ(jaw_of(odd.steadied(toon(), frame(time), time)),
              jaw_of(plain.steadied(toon(), frame(time), time)));
}

/// What a frame does not hold is not held; what comes new is as it was seen.
TEST(SteadyFrames, HoldWhatTheFrameHolds) {
  SteadyFrames steady;
  steady.steadied(toon(), frame(1), 0);
  EXPECT_TRUE(steady.steadied(toon(), {}, 0.1).empty());
  EXPECT_EQ(jaw_of(steady.steadied(toon(), frame(0), 0.2)), 0);
  Setting other = frame(0.5)[0];
  other.index = 1 << 20;
  EXPECT_EQ(jaw_of(steady.steadied(toon(), {other}, 0.3)), 0.5) << "of another face";
}

}  // namespace
}  // namespace mien
