#include "lib/rig/pose/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace mien {
namespace {

TEST(KeyCurve, IsExactAtItsKeysAndHeldBeyond) {
  const KeyCurve curve{{{0.1, 0.3}, {0.7, 1.0 / 3}, {0.9, -2}}};
  for (const CurveKey& key : curve.keys) EXPECT_EQ(value_at(curve, key.time), key.value);
  EXPECT_EQ(value_at(curve, -100), 0.3);
  EXPECT_EQ(value_at(curve, 100), -2);
  EXPECT_NEAR(value_at(curve, 0.8), (1.0 / 3 - 2) / 2, 1e-15);
}

TEST(KeyCurve, RepeatsForeverBothWays) {
  const KeyCurve curve{{{0, 0}, {1, 1}, {2, 0}}, 4};
  for (int k = -3; k <= 3; ++k) {
    EXPECT_EQ(value_at(curve, 4 * k + 0.5), 0.5);
    EXPECT_EQ(value_at(curve, 4 * k + 3), 0);
  }
  EXPECT_EQ(value_at(curve, std::nextafter(0.0, -1.0)), 0);
}

TEST(KeyCurve, EasesEachInItsWay) {
  const auto at = [](Ease ease, double u) { return value_at(KeyCurve{{{0, 0, ease}, {1, 1}}}, u); };
  EXPECT_EQ(at(Ease::linear, 0.25), 0.25);
  EXPECT_EQ(at(Ease::step, 0.999), 0);
  EXPECT_EQ(at(Ease::step, 1), 1);
  EXPECT_EQ(at(Ease::smooth, 0.5), 0.5);
  EXPECT_EQ(at(Ease::smooth, 0.25), 0.15625);
  EXPECT_EQ(at(Ease::in, 0.25), 0.0625);
  EXPECT_EQ(at(Ease::out, 0.25), 0.4375);
  double most = 0;
  for (double u = 0; u < 1; u += 0.001) most = std::max(most, at(Ease::overshoot, u));
  EXPECT_NEAR(most, 1.1, 1e-3);
  EXPECT_NEAR(at(Ease::overshoot, 0), 0, 1e-15);
}

TEST(SineCurve, IsWhatItSays) {
  for (double t = -10; t < 10; t += 0.37) {
    EXPECT_NEAR(value_at(SineCurve{2, 1.5, 0.5, 3, false}, t), 3 + 2 * std::sin(1.5 * t + 0.5),
                1e-14);
    EXPECT_NEAR(value_at(SineCurve{2, 1.5, 0.5, 3, true}, t),
                3 + 2 * std::abs(std::sin(1.5 * t + 0.5)), 1e-14);
  }
}

TEST(KeyCurve, ComesLaterByItsOffset) {
  const KeyCurve curve{{{0, 0}, {1, 1}, {2, 0}}, 4, 0.25};
  for (int k = -3; k <= 3; ++k) EXPECT_EQ(value_at(curve, 4 * k + 0.75), 0.5);
}

/// A blink with seeded jitter: once in every period, whole, at another moment of it (E10).
TEST(KeyCurve, JittersWithinItsPeriod_E10) {
  const KeyCurve curve{{{0, 0}, {0.1, 1}, {0.2, 0}}, 4, 0, 3, 7};
  double least = 9, most = 0;
  for (int k = -50; k < 50; ++k) {
    double shut = -1, area = 0;
    for (int i = 0; i < 4000; ++i) {
      const double value = value_at(curve, 4 * k + i * 0.001);
      area += value * 0.001;
      if (value > 0.99) shut = i * 0.001;
    }
    EXPECT_NEAR(area, 0.1, 1e-3) << k;  // one whole blink
    least = std::min(least, shut), most = std::max(most, shut);
    EXPECT_EQ(value_at(curve, 4.0 * k), 0);
  }
  EXPECT_GE(least, 0.1);
  EXPECT_LE(most, 3.11);
  EXPECT_LT(least, 0.3);  // it does use the room it has
  EXPECT_GT(most, 2.9);
}

TEST(KeyCurve, OfAnotherSeedJittersOtherwise) {
  const KeyCurve one{{{0, 0}, {0.1, 1}, {0.2, 0}}, 4, 0, 3, 1}, two{one.keys, 4, 0, 3, 2};
  int differ = 0;
  for (double t = 0; t < 100; t += 0.05) differ += value_at(one, t) != value_at(two, t);
  EXPECT_GT(differ, 20);
}

TEST(WanderCurve, RestsMovesQuicklyAndComesHome) {
  const WanderCurve curve{.center = 0.2,
                          .amplitude = 0.05,
                          .home = 0.5,
                          .period = 2,
                          .jitter = 1.5,
                          .move = 0.08,
                          .seed = 3};
  int moving = 0, home = 0, moments = 0;
  double before = value_at(curve, -50), least = 9, most = -9;
  for (double t = -50; t < 50; t += 0.001, ++moments) {
    const double value = value_at(curve, t);
    EXPECT_LT(std::abs(value - before), 1.5 * 0.1 / 0.08 * 0.001 + 1e-12) << t;  // no jump
    moving += value != before;
    home += value == 0.2;
    least = std::min(least, value), most = std::max(most, value);
    before = value;
  }
  EXPECT_GE(least, 0.15);
  EXPECT_LE(most, 0.25);
  EXPECT_GT(most - least, 0.06);
  EXPECT_LT(moving, moments * 0.08 / 2 * 1.2);
  EXPECT_NEAR(double(home) / moments, 0.5, 0.2);
}

/// Two curves of one seed look at the same moments, at places of their own, and are home together.
TEST(WanderCurve, OfOneSeedGoTogether) {
  const WanderCurve x{.home = 0.5, .period = 2, .jitter = 1.5, .seed = 3, .stream = 0},
      y{.home = 0.5, .period = 2, .jitter = 1.5, .seed = 3, .stream = 1};
  int elsewhere = 0;
  for (double t = 0; t < 100; t += 0.01) {
    const bool x_moves = value_at(x, t) != value_at(x, t + 0.001);
    const bool y_moves = value_at(y, t) != value_at(y, t + 0.001);
    EXPECT_EQ(x_moves, y_moves) << t;
    EXPECT_EQ(value_at(x, t) == 0, value_at(y, t) == 0) << t;
    elsewhere += value_at(x, t) != value_at(y, t);
  }
  EXPECT_GT(elsewhere, 1000);
}

TEST(Curves, AreTotalAndDependOnTheTimeAlone) {
  const Curve curves[] = {KeyCurve{{{0, 0}, {0.1, 1}}, 4, 1, 3, 7},
                          WanderCurve{.period = 0.7, .jitter = 0.5}};
  for (const Curve& curve : curves) {
    for (const double t : {1e300, -1e300, 1e17, -1e-300, 0.0})
      EXPECT_TRUE(std::isfinite(value_at(curve, t)));
    const double there = value_at(curve, 33.3);
    for (double t = 100; t > -100; t -= 7.7) value_at(curve, t);
    EXPECT_EQ(value_at(curve, 33.3), there);
  }
}

TEST(SampledCurve, IsExactAtRowsAndLinearBetween) {
  auto table = std::make_shared<SampleTable>();
  table->columns = 2;
  for (int i = 0; i < 1000; ++i) {
    // Steps of all lengths: few are where equal steps would have them.
    table->times.push_back(i < 500 ? i * 0.001 : 0.5 + (i - 500) * (i - 500) * 0.01);
    table->values.push_back(float(i % 7));
    table->values.push_back(0.25f);
  }
  const SampledCurve curve{table, 0}, still{table, 1};
  EXPECT_EQ(value_at(curve, -1), 0);
  EXPECT_EQ(value_at(curve, 1e9), double(999 % 7));
  EXPECT_EQ(value_at(curve, std::nan("")), 0) << "total";
  for (std::size_t i = 0; i + 1 < 1000; ++i) {
    const double a = table->times[i], b = table->times[i + 1];
    ASSERT_EQ(value_at(curve, a), double(i % 7));
    ASSERT_NEAR(value_at(curve, (a + b) / 2), (double(i % 7) + double((i + 1) % 7)) / 2, 1e-9);
    ASSERT_EQ(value_at(still, (a + b) / 2), 0.25);
  }
  const auto one = std::make_shared<SampleTable>(SampleTable{{2}, 1, {0.5f}});
  for (const double t : {1.0, 2.0, 3.0}) EXPECT_EQ(value_at(SampledCurve{one, 0}, t), 0.5);
}

}  // namespace
}  // namespace mien
