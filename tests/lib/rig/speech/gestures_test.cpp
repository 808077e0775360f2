#include "lib/rig/speech/gestures.h"

#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/motion_file.h>
#include <mien/poser.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

std::vector<SpokenAccent> accents_each(double gap, int count, bool rising = false) {
  std::vector<SpokenAccent> accents;
  for (int i = 0; i < count; ++i) accents.push_back({1 + gap * i, 1, rising});
  return accents;
}

TEST(Gestures, StaySmallAndSmooth) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const bool rising : {false, true}) {
      const auto accents = accents_each(kAccentGap, 40, rising);
      Gestures last = gestures_at(accents, seed, 0);
      for (double t = 0; t < 17; t += 0.005) {
        const Gestures now = gestures_at(accents, seed, t);
        ASSERT_LE(std::abs(now.pitch), kDeepestNod);
        ASSERT_TRUE(now.brows >= 0 && now.brows <= kHighestBrows);
        ASSERT_LT(std::abs(now.pitch - last.pitch), 0.005 * 60) << "degrees a second";
        ASSERT_LT(std::abs(now.brows - last.brows), 0.005 * 6);
        last = now;
      }
    }
}

/// Nods per accent, and raised brows.
std::pair<int, int> gestures_of(std::uint64_t seed, bool rising, int count = 40) {
  const auto accents = accents_each(2, count, rising);
  int nods = 0, lifts = 0;
  for (const SpokenAccent& accent : accents) {
    const Gestures now = gestures_at(accents, seed, accent.time + 0.04);
    nods += std::abs(now.pitch) > 0.5;
    lifts += now.brows > 0.05;
  }
  return {nods, lifts};
}

TEST(Gestures, NodOnSomeAccentsAndLiftBrowsOnFewer_EachSpeakerItsOwn) {
  int nods = 0, lifts = 0, least = 40, most = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto [nodded, lifted] = gestures_of(seed, false);
    nods += nodded, lifts += lifted;
    least = std::min(least, nodded), most = std::max(most, nodded);
  }
  EXPECT_NEAR(nods / 50.0 / 40, 0.62, 0.08);
  EXPECT_NEAR(lifts / 50.0 / 40, 0.35, 0.08);
  EXPECT_LT(least + 8, most);
  EXPECT_NE(gestures_at(accents_each(2, 9), 1, 1.04).pitch,
            gestures_at(accents_each(2, 9), 2, 1.04).pitch);
}

TEST(Gestures, GoUpWhereTheVoiceDoes) {
  EXPECT_EQ(gestures_of(7, true), std::pair(40, 40));
  const auto up = accents_each(2, 9, true), down = accents_each(2, 9);
  double deepest = 0;
  for (double t = 0; t < 18; t += 0.02) {
    EXPECT_GE(gestures_at(up, 3, t).pitch, 0);
    deepest = std::min(deepest, gestures_at(down, 3, t).pitch);
    EXPECT_LE(gestures_at(down, 3, t).pitch, 0);
  }
  EXPECT_LT(deepest, -1.5);
}

TEST(Gestures, AreAFunctionOfTimeAndOfNothingFarAway) {
  const auto accents = accents_each(2, 9);
  EXPECT_EQ(gestures_at({}, 1, 1).pitch, 0);
  for (const double t : {-1e9, 0.0, 2.0, 1e9}) {
    EXPECT_EQ(gestures_at(accents, 1, t).pitch, 0) << t;
    EXPECT_EQ(gestures_at(accents, 1, t).brows, 0) << t;
  }
}

TEST(Gestures, OfTwoAccentsThatAreCloseTakeTheStronger) {
  const auto accents = accents_of({{0, 0.2, Viseme::aa, 1, 0.5},
                                   {0.2, 0.4, Viseme::E, 1, 1},
                                   {0.4, 0.5, Viseme::E},
                                   {1, 1.02, Viseme::I, 1, 1},
                                   {1.02, 1.2, Viseme::I, 1, 0.2},
                                   {2, 2.2, Viseme::O, 1, 1, true}});
  ASSERT_EQ(accents.size(), 3u);
  EXPECT_NEAR(accents[0].time, 0.28, 1e-9);
  EXPECT_EQ(accents[0].strength, 1);
  EXPECT_LT(accents[1].strength, 0.5) << "a short sound";
  EXPECT_TRUE(accents[2].rising);
}

/// "a BIG ba-NA-na BOAT", by a dictionary.
constexpr char kWords[] =
    "0.0\tAH0\n0.1\tB\n0.2\tIH1\n0.4\tG\n0.5\tB\n0.6\tAH0\n0.7\tN\n0.8\tAE1\n1.0\tN\n1.1\tAH0\n"
    "1.3\tB\n1.4\tOW1\n1.7\tT\n1.8\tsil\n";

/// How much the gestures change of a person.
double moved(const Face& face, const Pose& with, const Pose& without, std::string_view slice) {
  const std::vector<double> a = test::slice_of(pose_face(face, with), slice),
                            b = test::slice_of(pose_face(face, without), slice);
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST(Gestures, MoveHeadAndBrowsOfFacesOnTopOfTheirIdleLife) {
  const Motion track = *read_motion_text(kWords);
  ASSERT_EQ(track.spoken.accents.size(), 3u);
  int nodded = 0, lifted = 0;
  for (int i = 0; i < 20; ++i) {
    const Face face =
        face_from_recipe(recipe_from_seed(seed_from_word(fmt::format("nods/{}", i)))).value();
    const BoundMotion bound = bind_motion(track, face);
    ASSERT_EQ(bound.motion->spoken.channels.size(), 3u) << "head and both brows";
    Index<Motion> idle{0};
    double head = 0, brow = 0;
    for (double t = 0; t < 2; t += 0.05) {
      const Pose with{.time = t, .motions = {{.clip = idle}, {.motion = bound.motion}}};
      Pose without = with, still = with, silent = with;
      without.gestures = 0;
      head = std::max(head, moved(face, with, without, "head/points/5"));
      brow = std::max(brow, moved(face, with, without, "brow.left/spine/1"));
      still.liveliness = 0;
      silent.liveliness = 0, silent.gestures = 0;
      ASSERT_EQ(pose_face(face, still).vector, pose_face(face, silent).vector)
          << "without liveliness the mouth alone speaks";
    }
    nodded += head > 0.002, lifted += brow > 0.004;
  }
  EXPECT_GE(nodded, 15);
  EXPECT_GE(lifted, 12);
}

}  // namespace
}  // namespace mien
