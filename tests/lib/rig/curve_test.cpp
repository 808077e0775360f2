#include <mien/lib/rig/curve.h>

#include <gtest/gtest.h>

#include <cmath>

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
}

TEST(SineCurve, IsWhatItSays) {
  for (double t = -10; t < 10; t += 0.37) {
    EXPECT_EQ(value_at(SineCurve{2, 1.5, 0.5, 3, false}, t), 3 + 2 * std::sin(1.5 * t + 0.5));
    EXPECT_EQ(value_at(SineCurve{2, 1.5, 0.5, 3, true}, t),
              3 + 2 * std::abs(std::sin(1.5 * t + 0.5)));
  }
}

}  // namespace
}  // namespace mien
