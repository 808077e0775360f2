#include "lib/rig/idle/idle.h"

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

double part(IdlePart of, std::uint64_t seed, double time, double liveliness = 1) {
  return idle_at(seed, time, liveliness)[std::size_t(of)];
}

/// [ms] when the right lid begins to fall, within a minute.
std::vector<int> blinks_of(std::uint64_t seed, double liveliness = 1) {
  std::vector<int> times;
  bool open = true;
  for (int ms = 0; ms < 60'000; ms += 5) {
    const double shut = part(IdlePart::blink_right, seed, ms / 1000.0, liveliness);
    if (shut > 0 && open) times.push_back(ms);
    open = shut == 0;
  }
  return times;
}

TEST(Idle, BlinksAsOftenAsPeopleDo_EachInTimeOfTheirOwn) {
  std::set<std::vector<int>> all;
  std::size_t most = 0, least = 99, sum = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto times = blinks_of(seed);
    all.insert(times);
    most = std::max(most, times.size()), least = std::min(least, times.size());
    sum += times.size();
  }
  EXPECT_EQ(all.size(), 100u) << "no two blink alike";
  EXPECT_GE(least, 6u);
  EXPECT_LE(most, 32u);
  EXPECT_NEAR(double(sum) / 100, 17, 4) << "a minute";
}

/// One blink in twelve or so is no whole one.
TEST(Idle, AFewBlinksShutLidsHalf) {
  int all = 0, half = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    double deepest = 0;
    for (int ms = 0; ms < 60'000; ms += 10) {
      const double shut = part(IdlePart::blink_right, seed, ms / 1000.0);
      if (shut == 0 && deepest > 0) ++all, half += deepest < 0.8;
      deepest = shut == 0 ? 0 : std::max(deepest, shut);
    }
  }
  EXPECT_GT(all, 400);
  EXPECT_NEAR(double(half) / all, 0.08, 0.03);
}

/// Which 9 of 299 steps of a film of 10 s move a face most: what its pixels change by, about, at 96 pixels.
std::array<bool, 299> largest_moves_of(std::uint64_t seed) {
  std::array<double, 299> moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const IdleNumbers a = idle_at(seed, double(i) / 30), b = idle_at(seed, double(i + 1) / 30);
    const auto by = [&](IdlePart of) { return std::abs(b[std::size_t(of)] - a[std::size_t(of)]); };
    const double turn =
        std::hypot(by(IdlePart::yaw), by(IdlePart::pitch)) + 1.5 * by(IdlePart::roll);
    const double head = 650 * turn / (turn + 0.6);
    const double eyes = std::min(1.0, 10 * (by(IdlePart::gaze_x) + by(IdlePart::gaze_y))),
                 lids = std::min(1.0, 5 * by(IdlePart::blink_left));
    moves[i] = head + 110 * std::max(eyes, lids) * (1 - head / 900);
  }
  auto sorted = moves;
  std::sort(sorted.begin(), sorted.end());
  std::array<bool, 299> largest;
  std::transform(moves.begin(), moves.end(), largest.begin(),
                 [&](double move) { return move > sorted[289]; });
  return largest;
}

/// In a crowd nobody moves as another does at the same time: among 400 people fewer than one pair in 1000 has more than
/// half of its largest moves together. (With necks of one slow spring there were ten.)
TEST(Idle, NoTwoOfACrowdMoveTogether) {
  std::vector<std::array<bool, 299>> crowd;
  int pairs = 0, together = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const auto moves = largest_moves_of(seed * 7919);
    for (const auto& other : crowd) {
      int both = 0;
      for (std::size_t i = 0; i < moves.size(); ++i) both += moves[i] && other[i];
      ++pairs, together += both >= 5;
    }
    crowd.push_back(moves);
  }
  EXPECT_LT(together, pairs / 1000) << "of " << pairs;
}

/// Less lively faces blink less often, at moments at which they would have blinked anyway, and as far.
TEST(Idle, IsSmallerAndBlinksLessWithLessLiveliness) {
  const auto whole = blinks_of(5), half = blinks_of(5, 0.5);
  EXPECT_LT(half.size(), whole.size());
  EXPECT_TRUE(std::includes(whole.begin(), whole.end(), half.begin(), half.end()));
  for (double t = 0; t < 30; t += 0.07) {
    const IdleNumbers one = idle_at(5, t), less = idle_at(5, t, 0.25), none = idle_at(5, t, 0);
    for (std::size_t i = 0; i < kIdleParts; ++i) {
      EXPECT_EQ(none[i], 0);
      const bool blinks =
          IdlePart(i) == IdlePart::blink_left || IdlePart(i) == IdlePart::blink_right;
      if (!blinks) {
        EXPECT_NEAR(less[i], 0.25 * one[i], 1e-15);
      }
    }
  }
}

/// Nothing jumps but the eyes, which take 40 ms at least; all stays within its bounds; everything moves.
TEST(Idle, IsContinuousAndWithinBounds) {
  constexpr double kStep = 0.002;
  struct Bound {
    IdlePart part;
    double most, speed;  // a second
  };
  const Bound bounds[] = {{IdlePart::gaze_x, 0.45, 12},   {IdlePart::gaze_y, 0.25, 8},
                          {IdlePart::yaw, 11, 60},        {IdlePart::pitch, 6, 40},
                          {IdlePart::roll, 2.8, 8},       {IdlePart::blink_left, 1, 22},
                          {IdlePart::blink_right, 1, 22}, {IdlePart::breath, 1, 1.6},
                          {IdlePart::corner_left, 1, 6},  {IdlePart::corner_right, 1, 6},
                          {IdlePart::brow_left, 1.5, 12}, {IdlePart::brow_right, 1.5, 12},
                          {IdlePart::dilation, 1, 1}};
  for (const std::uint64_t seed : {1u, 2u, 77u, 123456u}) {
    IdleNumbers before = idle_at(seed, -kStep), least = before, most = before;
    for (int i = 0; i < 60'000; ++i) {
      const IdleNumbers now = idle_at(seed, i * kStep);
      for (const auto& [of, reach, speed] : bounds) {
        const auto n = std::size_t(of);
        ASSERT_LE(std::abs(now[n]), reach) << n << " at " << i * kStep;
        ASSERT_LE(std::abs(now[n] - before[n]), speed * kStep + 2e-3) << n << " at " << i * kStep;
        least[n] = std::min(least[n], now[n]), most[n] = std::max(most[n], now[n]);
      }
      before = now;
    }
    for (const auto& [of, reach, speed] : bounds)
      EXPECT_GT(most[std::size_t(of)] - least[std::size_t(of)], 0.3 * reach) << int(of);
  }
}

/// Eyes stay on what they look at while the head turns: between two glances, the angle of the eyes in the head and the
/// head's own add up to the same.
TEST(Idle, EyesYieldToTheHead) {
  int still = 0;
  for (double t = 0; t < 60; t += 0.02) {
    const auto gaze = [&](double at) {
      const IdleNumbers now = idle_at(9, at);
      return std::asin(now[std::size_t(IdlePart::gaze_x)]) * (180 / M_PI) +
             now[std::size_t(IdlePart::yaw)];
    };
    const double moved = std::abs(part(IdlePart::yaw, 9, t + 0.02) - part(IdlePart::yaw, 9, t));
    if (moved > 0.02 && std::abs(gaze(t + 0.02) - gaze(t)) < 1e-6) ++still;
  }
  EXPECT_GT(still, 2000) << "of 3000 steps";
}

TEST(Idle, IsTheSameAtAnyTimeInAnyOrder) {
  const IdleNumbers then = idle_at(4, 33.3);
  for (double t = 100; t > -100; t -= 7.7) idle_at(4, t);
  EXPECT_EQ(idle_at(4, 33.3), then);
  EXPECT_NE(idle_at(5, 33.3), then);
  for (const double time : {1e300, -1e300, 1e17, -1e-300, 0.0, 6e7, -6e7})
    for (const double number : idle_at(4, time)) EXPECT_TRUE(std::isfinite(number)) << time;
}

/// A clip of life moves the controls that the face has, by their units, and mixes as other clips do.
TEST(Idle, IsAClipOfAFace) {
  const Face face = *read_face_text(R"({"format": "mien-face", "format_version": 1,
    "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"ink": "#000000"}, "background": "ink",
    "features": [{"name": "dot", "kind": "disc", "side": "left", "paint": "ink", "center": [0.5, 0], "radius": 0.1}],
    "controls": [{"name": "yaw", "range": [-30, 30], "rest": 3, "offset": {"dot/center": [0, 1]}},
                 {"name": "breath", "range": [0, 10], "rest": 0, "offset": {"dot/center": [1, 0]}},
                 {"name": "life", "range": [0, 1], "rest": 0, "offset": {"dot/center": [0, 5]}}],
    "clips": {"idle": {"life": ["head", "breath"]}, "more": {"life": ["head"], "additive": true},
              "curves": {"life": [{"keys": [[0, 0.5]]}]}},
    "default_clip": "idle"})");
  const auto dot = [&](const Pose& pose) {
    return test::slice_of(pose_face(face, pose), "dot.left/center");
  };
  const double t = 4.7;
  const auto& idle = idle_at(7, t);
  const double yaw = idle[std::size_t(IdlePart::yaw)];
  const auto now = dot({.time = t, .seed = 7});
  EXPECT_NEAR(now[1], yaw, 1e-12);
  EXPECT_NEAR(now[0], 0.5 + 3 * idle[std::size_t(IdlePart::breath)], 1e-12);
  const auto layer = [&](const char* text) { return *read_clip_layer(face, text); };
  EXPECT_NEAR(dot({.time = t, .motions = {layer("idle=0.5")}, .seed = 7})[1], 0.5 * yaw, 1e-12);
  EXPECT_NEAR(dot({.time = t, .motions = {layer("idle"), layer("more=2")}, .seed = 7})[1], 3 * yaw,
              1e-12);
  EXPECT_NEAR(dot({.time = t, .motions = {layer("curves")}})[1], 2.5, 1e-12) << "a control's name";
  EXPECT_NEAR(dot({.time = t + 2, .motions = {layer("idle=1@2")}, .seed = 7})[1], yaw, 1e-12);
  EXPECT_NEAR(dot({.time = t, .seed = 7, .liveliness = 0.5})[1], 0.5 * yaw, 1e-12);
  EXPECT_EQ(pose_face(face, {.time = t, .seed = 7, .liveliness = 0}).vector, face.vector);
  EXPECT_EQ(pose_face(face, {.seed = 7}).vector, face.vector) << "no time, no life";
}

/// When the left lid is more than half down, of a minute.
std::vector<double> down_of(std::uint64_t seed, const BlinkHolds& holds) {
  std::vector<double> down;
  for (int ms = 0; ms < 60'000; ms += 5)
    if (idle_at(seed, ms / 1000.0, 1, holds)[std::size_t(IdlePart::blink_left)] > 0.5)
      down.push_back(ms / 1000.0);
  return down;
}

/// Lips that meet two or three times a second, for 80 to 200 ms.
std::vector<SpokenSpan> closures(std::uint64_t seed) {
  std::vector<SpokenSpan> spans;
  double time = -2;
  for (std::uint64_t i = 0; time < 62; ++i) {
    const double draw = double((seed * 7919 + i * 104729) % 97) / 97;
    spans.push_back({time, time + 0.08 + 0.12 * draw});
    time += 0.3 + 0.4 * draw;
  }
  return spans;
}

TEST(Idle, BlinksInNoMiddleOfAClosure) {
  std::size_t free = 0, held = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto spans = closures(seed);
    for (const double later : {0.0, 0.73}) {
      const auto down = down_of(seed, {spans, later});
      for (const double t : down)
        for (const SpokenSpan& span : spans)
          ASSERT_FALSE(t > span.begin + later && t < span.end + later) << seed << " at " << t;
      held += down.size();
    }
    free += 2 * down_of(seed, {}).size();
  }
  EXPECT_GT(double(held), 0.75 * double(free)) << "they wait; few are not blinked";
}

TEST(Idle, BlinksInClosuresThatLast) {
  const std::vector<SpokenSpan> hum{{-5, 65}};
  EXPECT_EQ(down_of(4, {hum}), down_of(4, {}));
}

TEST(Idle, IsOtherwiseTheSameWhileTheFaceSpeaks) {
  const auto spans = closures(3);
  for (double t = 0; t < 20; t += 0.1) {
    IdleNumbers a = idle_at(9, t), b = idle_at(9, t, 1, {spans});
    for (const IdlePart part : {IdlePart::blink_left, IdlePart::blink_right})
      a[std::size_t(part)] = b[std::size_t(part)] = 0;
    ASSERT_EQ(a, b);
  }
}

}  // namespace
}  // namespace mien
