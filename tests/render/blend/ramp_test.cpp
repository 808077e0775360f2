#include "render/blend/ramp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

constexpr Color kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};

double red(const Ramp& ramp, double t) {
  return ramp.color(t).r;
}

Ramp black_to_white(Extend extend) {
  return Ramp({LinearGradient{}, {{0, kBlack}, {1, kWhite}}, extend}, 1, Blend::linear);
}

TEST(Ramp, MixesStopsAndExtendsThem) {
  for (const double t : {-1.7, -0.25, 0.0, 0.3, 0.75, 1.25, 2.6}) {
    SCOPED_TRACE(t);
    EXPECT_NEAR(red(black_to_white(Extend::pad), t), std::fmin(std::fmax(t, 0), 1), 1e-15);
    EXPECT_NEAR(red(black_to_white(Extend::repeat), t), t - std::floor(t), 1e-15);
    EXPECT_NEAR(red(black_to_white(Extend::reflect), t), std::abs(std::remainder(t, 2)), 1e-15);
  }
}

TEST(Ramp, MixesPremultiplied) {
  const Ramp ramp({LinearGradient{}, {{0, {1, 0, 0, 0}}, {1, {0, 0, 1, 1}}}}, 0.5, Blend::linear);
  EXPECT_EQ(ramp.color(0.5), (Mix{0, 0, 0.25, 0.25}));  // no red: it is nowhere to be seen
  EXPECT_EQ(ramp.least_opacity(), 0);
  EXPECT_EQ(ramp.most_opacity(), 0.5);
}

TEST(Ramp, JumpsWhereTwoStopsMeet) {
  const Ramp ramp({LinearGradient{}, {{0, kBlack}, {0.5, kBlack}, {0.5, kWhite}, {1, kWhite}}}, 1,
                  Blend::linear);
  EXPECT_EQ(red(ramp, std::nextafter(0.5, 0)), 0);
  EXPECT_EQ(red(ramp, 0.5), 1);
  std::vector<double> kinks;
  EXPECT_TRUE(ramp.kinks(0.4, 0.6, 9, kinks));
  EXPECT_EQ(kinks, std::vector<double>{0.5});
}

TEST(Ramp, KnowsHowSteepItIsBetweenStops) {
  const Gradient gradient{
      .stops = {
          {0.0, {0, 0, 0, 1}}, {0.5, {0.2, 0, 0, 1}}, {0.5, {1, 1, 1, 1}}, {1.0, {1, 0, 1, 1}}}};
  EXPECT_DOUBLE_EQ(Ramp(gradient, 1.0, Blend::srgb).steepest(), 2.0);
}

TEST(Ramp, NamesEveryKinkBetweenTwoPlaces) {
  std::vector<double> kinks;
  EXPECT_TRUE(black_to_white(Extend::reflect).kinks(-1.5, 2.5, 9, kinks));
  EXPECT_EQ(kinks, (std::vector<double>{-1, 0, 1, 2}));
  EXPECT_TRUE(black_to_white(Extend::pad).kinks(-1.5, 2.5, 9, kinks));
  EXPECT_EQ(kinks, (std::vector<double>{0, 1}));
  EXPECT_FALSE(black_to_white(Extend::repeat).kinks(0, 1e9, 9, kinks));
  EXPECT_TRUE(kinks.empty());
}

TEST(Ramp, OfStopsThatFallOrAreMissingIsStillARamp) {
  const Ramp falling({LinearGradient{}, {{1, kBlack}, {0, kWhite}}}, 1, Blend::linear);
  EXPECT_EQ(red(falling, 0.9), 0);
  EXPECT_EQ(red(falling, 1), 1);
  EXPECT_EQ(Ramp({LinearGradient{}, {}}, 1, Blend::linear).color(0.3), Mix{0.0});
}

}  // namespace
}  // namespace mien
