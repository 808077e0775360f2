#include "lib/rig/speech/coarticulation.h"

#include "lib/rig/pose/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

}  // namespace
}  // namespace mien
