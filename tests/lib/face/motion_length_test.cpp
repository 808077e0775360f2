#include <mien/motion_length.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace mien {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Motion clip_of(std::vector<Curve> curves) {
  Motion clip{.name = "a", .channels = {}};
  for (Curve& curve : curves) clip.channels.push_back({"a", {std::move(curve)}});
  return clip;
}
KeyCurve keys(double last, double period = 0, double offset = 0) {
  return {.keys = {{0, 0}, {last, 1}}, .period = period, .offset = offset};
}
SineCurve sine(double period, bool absolute = false) {
  return {.frequency = 2 * M_PI / period, .absolute = absolute};
}

TEST(MotionLength, IsThatOfTheLastKey) {
  EXPECT_EQ(motion_length(clip_of({})), 0);
  EXPECT_EQ(motion_length(clip_of({keys(1.5), keys(0.75)})), 1.5);
  EXPECT_EQ(motion_length(clip_of({keys(1.5, 0, 0.25)})), 1.75);
  EXPECT_EQ(motion_length(clip_of({keys(1.5, 0, -4)})), 0);
}

TEST(MotionLength, IsWhenAllPeriodsAreTogetherAgain) {
  EXPECT_EQ(motion_length(clip_of({keys(1, 4)})), 4);
  EXPECT_EQ(motion_length(clip_of({keys(1, 12), keys(1, 4)})), 12);
  EXPECT_EQ(motion_length(clip_of({keys(1, 3), keys(1, 4), keys(1, 0.5)})), 12);
  EXPECT_NEAR(motion_length(clip_of({keys(1, 0.1), keys(1, 0.3), keys(1, 0.7)})), 2.1, 1e-12);
  EXPECT_NEAR(motion_length(clip_of({sine(2.5), keys(1, 1)})), 5, 1e-12);
  EXPECT_NEAR(motion_length(clip_of({sine(5, true)})), 2.5, 1e-12);
  EXPECT_EQ(motion_length(clip_of({keys(9), keys(1, 4)})),
            12);  // the end of what runs once is shown, too
  EXPECT_EQ(motion_length(clip_of({keys(1, 5000)})), 5000);
}

TEST(MotionLength, CountsAllCurvesOfATrack) {
  const Motion clip{.name = "a", .channels = {{"a", {keys(1, 4), keys(1, 6)}}}};
  EXPECT_EQ(motion_length(clip), 12);
}

TEST(MotionLength, IsEndlessWhereNothingComesAgain) {
  KeyCurve late = keys(1, 4);
  late.jitter = 0.5;
  EXPECT_EQ(motion_length(clip_of({late})), kEndless);
  Motion life;
  life.idle = {{IdlePart::yaw, {0}}};
  EXPECT_EQ(motion_length(life), kEndless);
  EXPECT_EQ(motion_length(clip_of({WanderCurve{}, keys(1)})), kEndless);
  EXPECT_EQ(motion_length(clip_of({sine(1), sine(std::sqrt(2.0))})), kEndless);
  EXPECT_EQ(motion_length(clip_of({keys(1, 5000), keys(1, 7)})), kEndless);
  EXPECT_EQ(motion_length(clip_of({keys(1, 1e-300), keys(1, 7)})), 7);
}

TEST(MotionLength, OfACurveIsItsTurn) {
  EXPECT_EQ(period_of(keys(2)), 0);
  EXPECT_EQ(period_of(keys(2, 3)), 3);
  EXPECT_EQ(period_of(WanderCurve{.period = 1.5}), 1.5);
  EXPECT_EQ(period_of(SineCurve{.frequency = 0}), 0);
}

TEST(MotionLength, OfSamplesIsTheirLastMoment) {
  const auto table = std::make_shared<SampleTable>(SampleTable{{0, 2.5}, 1, {0, 1}});
  EXPECT_EQ(motion_length(clip_of({SampledCurve{table, 0}})), 2.5);
  EXPECT_EQ(period_of(SampledCurve{table, 0}), 0);
}

}  // namespace
}  // namespace mien
