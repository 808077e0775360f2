#include "lib/rig/speech/coarticulation.h"

#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/poser.h>
#include "lib/rig/pose/curve.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

double weight(const Motion& motion, Viseme viseme, double time) {
  return value_at(motion.channels[std::size_t(viseme)].curves[0], time);
}

const SampleTable& table(const Motion& motion) {
  return *std::get<SampledCurve>(motion.channels[0].curves[0]).table;
}

/// A track as fast as speech is, and faster: a few sounds have no length, a few last a second.
SpeechTrack random_track(std::uint64_t seed, int count = 60) {
  std::mt19937_64 bits(seed);
  const auto draw = [&] { return double(bits() >> 11) * 0x1p-53; };
  SpeechTrack track;
  double time = draw();
  for (int i = 0; i < count; ++i) {
    const double kind = draw();
    const double length = kind < 0.05 ? 0 : kind > 0.97 ? 1 : 0.02 + 0.15 * draw();
    track.push_back({time, time + length, Viseme(bits() % kVisemes), 0.5 + 0.5 * draw()});
    time += length + (draw() < 0.1 ? 0.2 * draw() : 0);
  }
  return track;
}

TEST(Coarticulation, ClosesForEveryClosingSound) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const SpeechTrack track = random_track(seed);
    const Motion motion = coarticulated(track, "t");
    for (const Phone& phone : track) {
      if (!is_contact(phone.viseme)) continue;
      const auto [begin, end] = contact_of(phone);
      ASSERT_GE(end - begin, kLeastContact - 1e-12);
      if (phone.end - phone.begin >= kLeastContact) {
        ASSERT_TRUE(begin >= phone.begin && end <= phone.end) << "within the sound";
      }
      for (int i = 0; i <= 100; ++i)
        ASSERT_EQ(weight(motion, phone.viseme, begin + (end - begin) * i / 100), 1)
            << seed << " at " << begin;
    }
  }
}

TEST(Coarticulation, KeepsItsSpeedLimits) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Motion motion = coarticulated(random_track(seed), "t");
    const SampleTable& all = table(motion);
    for (std::size_t row = 1; row < all.times.size(); ++row)
      for (int v = 0; v < kVisemes; ++v) {
        const double step = all.times[row] - all.times[row - 1];
        const double change =
            std::abs(double(all.at(row, std::size_t(v))) - double(all.at(row - 1, std::size_t(v))));
        const bool carries = is_vowel(Viseme(v)) || Viseme(v) == Viseme::sil;
        const double limit = is_contact(Viseme(v)) ? 1 / kContactRamp
                             : carries             ? kJawSpeed
                                                   : kLipsSpeed;
        // Numbers are kept to 24 bits, and what is farther than the reach counts for nothing.
        ASSERT_LE(change, limit * step + 1e-3) << seed << " " << v << " at " << all.times[row];
      }
  }
  EXPECT_LT(kJawSpeed, kLipsSpeed);
}

TEST(Coarticulation, SharesAreShares) {
  const Motion motion = coarticulated(random_track(7), "t");
  const SampleTable& all = table(motion);
  for (std::size_t row = 0; row < all.times.size(); ++row) {
    double vowels = 0;
    for (int v = 0; v < kVisemes; ++v) {
      const double w = double(all.at(row, std::size_t(v)));
      ASSERT_TRUE(w >= 0 && w <= 1);
      if (is_vowel(Viseme(v))) vowels += w;
    }
    ASSERT_LE(vowels, 1 + 1e-6);
  }
}

/// "ama": the jaw, which the vowel carries, goes on while the lips are shut, and does not shut.
TEST(Coarticulation, LetsTheJawGoOnWhileLipsAreShut) {
  const SpeechTrack ama = {{0, 0.2, Viseme::aa}, {0.2, 0.3, Viseme::PP}, {0.3, 0.5, Viseme::aa}};
  const Motion motion = coarticulated(ama, "ama");
  const auto [begin, end] = contact_of(ama[1]);
  double least = 1, most = 0;
  for (double t = begin; t <= end; t += 0.005) {
    EXPECT_EQ(weight(motion, Viseme::PP, t), 1);
    least = std::min(least, weight(motion, Viseme::aa, t));
    most = std::max(most, weight(motion, Viseme::aa, t));
  }
  EXPECT_GT(least, 0.4);
  EXPECT_LT(least, 0.65);
  EXPECT_GT(most - least, 0.02) << "it moves";
  EXPECT_LT(weight(motion, Viseme::PP, 0.1), 0.1);
  EXPECT_GT(weight(motion, Viseme::aa, 0.1), 0.75);
}

TEST(Coarticulation, RestsBeforeAndAfterAndClosesInGaps) {
  const Motion motion = coarticulated({{1, 1.2, Viseme::aa}, {2.2, 2.4, Viseme::O}}, "t");
  for (int v = 0; v < kVisemes; ++v) {
    EXPECT_EQ(weight(motion, Viseme(v), -1), weight(motion, Viseme(v), -2));
    EXPECT_LT(weight(motion, Viseme(v), 0.2), 1e-3);
    EXPECT_LT(weight(motion, Viseme(v), 3.5), 1e-3);
  }
  EXPECT_GT(weight(motion, Viseme::sil, 1.7), 0.99);
}

TEST(Coarticulation, TakesTracksThatOverlapOrAreEmpty) {
  EXPECT_EQ(coarticulated({}, "t").channels.size(), std::size_t(kVisemes));
  const Motion motion = coarticulated(
      {{0, 3600, Viseme::aa}, {1, 1, Viseme::PP}, {1, 1, Viseme::PP}, {1, 2, Viseme::O}}, "t");
  EXPECT_EQ(weight(motion, Viseme::PP, 1), 1);
  EXPECT_GT(weight(motion, Viseme::aa, 0.5), 0.99);
  EXPECT_LT(weight(motion, Viseme::aa, 1.6), 0.01) << "a sound ends where the next begins";
}

/// What a file may hold, whoever wrote it: work grows with its sounds and with its length, not with their product.
TEST(Coarticulation, TakesManySoundsAtOneMoment) {
  SpeechTrack track;
  for (int i = 0; i < 50'000; ++i)
    track.push_back({i * 1e-6, 3600, i % 2 ? Viseme::PP : Viseme::aa});
  const Motion motion = coarticulated(track, "t");
  EXPECT_EQ(weight(motion, Viseme::PP, 0.02), 1);
  EXPECT_LT(table(motion).times.size(), 200u);
}

TEST(Coarticulation, IsAFunctionOfTime) {
  const SpeechTrack track = random_track(3);
  const Motion one = coarticulated(track, "t"), other = coarticulated(track, "t");
  EXPECT_EQ(table(one).values, table(other).values);
  EXPECT_TRUE(one.settled);
}

// What it promises of weights is seen in mouths: people say a sentence in every mood.

using test::point_of;

constexpr int kPeople = 50, kMoments = 8;
constexpr std::array<const char*, 5> kMoods{"emotion.joy=0", "emotion.joy=1", "emotion.anger=1",
                                            "emotion.sadness=1", "emotion.surprise=1"};

/// "mama, a five boom", with sounds shorter than a contact lasts, and long ones.
const SpeechTrack kSentence{
    {0.00, 0.10, Viseme::PP}, {0.10, 0.25, Viseme::aa}, {0.25, 0.31, Viseme::PP},
    {0.31, 0.50, Viseme::aa}, {0.60, 0.70, Viseme::aa}, {0.70, 0.85, Viseme::FF},
    {0.85, 1.00, Viseme::aa}, {1.00, 1.06, Viseme::I},  {1.06, 1.11, Viseme::FF},
    {1.11, 1.20, Viseme::O},  {1.20, 1.21, Viseme::PP}, {1.21, 1.40, Viseme::U},
    {1.40, 1.70, Viseme::PP}};

std::vector<Face> speakers() {
  std::vector<Face> all{test::sample_face("faces/toon"), test::sample_face("faces/bruno"),
                        test::sample_face("faces/clay")};
  for (int i = 0; i < kPeople; ++i)
    all.push_back(
        face_from_recipe(recipe_from_seed(seed_from_word(fmt::format("speaks/{}", i)))).value());
  return all;
}

double edge_of_teeth(const Face& face) {
  return 0.5 * point_of(face, "teeth/points/2").y +
         0.25 * (point_of(face, "teeth/points/1").y + point_of(face, "teeth/points/3").y);
}

double chin(const Face& face) {
  return point_of(face, "head/points/5").y;
}

/// For all speakers, moods and moments of the contacts of a shape.
template <class Look>
void during(Viseme viseme, Look&& look) {
  const Motion said = coarticulated(kSentence, "sentence");
  for (const Face& face : speakers()) {
    const BoundMotion bound = bind_motion(said, face);
    ASSERT_TRUE(bound.unfollowed.empty());
    Poser poser(face);
    for (const char* mood : kMoods) {
      Pose pose = test::pose_of(face, {mood});
      pose.motions = {{.motion = bound.motion}};
      for (const Phone& phone : kSentence) {
        if (phone.viseme != viseme) continue;
        const auto [begin, end] = contact_of(phone);
        ASSERT_GE(end - begin, kLeastContact - 1e-12);
        look(face, poser, pose, begin, end, fmt::format("{} {} {}", face.model->name, mood, begin));
      }
    }
  }
}

TEST(SpokenCoarticulation, ShutsForEveryClosingSoundWhileTheChinGoesOn) {
  during(Viseme::PP, [&](const Face& face, Poser& poser, Pose& pose, double begin, double end,
                         const std::string& what) {
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i <= kMoments; ++i) {
      pose.time = begin + (end - begin) * i / kMoments;
      const Face& posed = poser.pose(pose);
      ASSERT_EQ(test::inner_edge_of(posed, "upper"), test::inner_edge_of(posed, "lower")) << what;
      lowest = std::min(lowest, chin(posed)), highest = std::max(highest, chin(posed));
    }
    const bool between_vowels = begin > 0.1 && begin < 1.3;
    if (!between_vowels) return;
    const double drop = face.model->mouth->drop;
    EXPECT_LT(highest, chin(without_mood(face)) - 0.03 * drop) << what << ": the jaw is down";
    EXPECT_GT(highest - lowest, 0.002 * drop) << what << ": it goes on";
  });
}

TEST(SpokenCoarticulation, TouchesTheUpperTeethForEveryFAndV) {
  during(Viseme::FF, [&](const Face& face, Poser& poser, Pose& pose, double begin, double end,
                         const std::string& what) {
    for (int i = 0; i <= kMoments; ++i) {
      pose.time = begin + (end - begin) * i / kMoments;
      const Face& posed = poser.pose(pose);
      const double lip = point_of(posed, "lower_edge.left/spine/0").y, teeth = edge_of_teeth(posed);
      ASSERT_GT(lip, teeth) << what;
      ASSERT_LT(lip, teeth + 0.03 * face.model->mouth->width) << what;
    }
  });
}

/// The proofs see mouths that stay open: between the contacts they are.
TEST(SpokenCoarticulation, OpensForVowels) {
  for (const Face& face : speakers()) {
    const BoundMotion bound = bind_motion(coarticulated(kSentence, "sentence"), face);
    Pose pose;
    pose.motions = {{.motion = bound.motion}};
    for (const double vowel : {0.18, 0.42, 0.93}) {
      pose.time = vowel;
      const Face posed = pose_face(face, pose);
      EXPECT_GT(point_of(posed, "upper_edge.left/spine/0").y -
                    point_of(posed, "lower_edge.left/spine/0").y,
                0.05)
          << face.model->name << vowel;
    }
  }
}

}  // namespace
}  // namespace mien
