#include "lib/parts/compose/hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kAmplitude = 0.014, kWidth = 0.3;

TEST(Hand, MovesNoPlaceFartherThanItsAmplitude) {
  double farthest = 0;
  for (std::uint64_t person = 0; person < 50; ++person) {
    const Hand hand(person, kAmplitude, kWidth);
    for (double x = -1; x <= 1; x += 0.1)
      for (double y = -1; y <= 1; y += 0.1) {
        const glm::dvec2 by = hand.moved({x, y}) - glm::dvec2{x, y};
        farthest = std::max({farthest, std::abs(by.x), std::abs(by.y)});
      }
  }
  EXPECT_LE(farthest, kAmplitude);
  EXPECT_GT(farthest, kAmplitude / 2) << "it draws";
}

/// The plane is bent, not folded: places side by side stay so.
TEST(Hand, KeepsWhatLiesTogetherTogether) {
  constexpr double kStep = 1e-3, kFastest = 2.6, kTurn = 6.283185307179586;
  for (std::uint64_t person = 0; person < 50; ++person) {
    const Hand hand(person, kAmplitude, kWidth);
    for (double x = -1; x <= 1; x += 0.05) {
      const glm::dvec2 step = hand.moved({x + kStep, 0.3}) - hand.moved({x, 0.3});
      EXPECT_NEAR(step.x, kStep, kStep * kTurn * kFastest * kAmplitude);
    }
  }
}

TEST(Hand, IsAPersonsOwn) {
  const Hand one(1, kAmplitude, kWidth), again(1, kAmplitude, kWidth), other(2, kAmplitude, kWidth);
  const glm::dvec2 place{0.2, -0.4};
  EXPECT_EQ(one.moved(place), again.moved(place));
  EXPECT_GT(glm::distance(one.moved(place), other.moved(place)), 1e-4);
  EXPECT_EQ(one.thickness("brow", 1), again.thickness("brow", 1));
  EXPECT_NE(one.thickness("brow", 1), one.thickness("brow", 2));
  EXPECT_NE(one.thickness("brow", 1), one.thickness("nose", 1));
}

TEST(Hand, LinesKeepAWidth) {
  for (std::uint64_t person = 0; person < 200; ++person) {
    const double share = Hand(person, kAmplitude, kWidth).thickness("brow", int(person));
    EXPECT_GT(share, 1 - kWidth);
    EXPECT_LT(share, 1 + kWidth);
  }
  EXPECT_EQ(Hand(1, 0, 0).thickness("brow", 0), 1);
  EXPECT_EQ(Hand(1, 0, 0).moved({0.5, 0.25}), (glm::dvec2{0.5, 0.25}));
}

}  // namespace
}  // namespace mien
