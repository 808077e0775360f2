#include "render/shade/ramp/integral.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/random.h"
#include "tests/support/random_ramp.h"

namespace mien::test {
namespace {

RampPlane random_plane(Random& r, const Ramp& ramp) {
  const double size = std::pow(10, r.between(-2, 1)) * (ramp.at().back() - ramp.at().front() + 0.1),
               turn = r.between(0, 6.3), kind = r.between(0, 1);
  RampPlane plane{r.between(-2, 3), size * std::cos(turn), size * std::sin(turn)};
  if (kind < 0.2) plane.gx *= r.between(0, 1) < 0.5 ? 0.0 : 5e-4;
  if (kind > 0.8) plane.gy *= r.between(0, 1) < 0.5 ? 0.0 : 5e-4;
  return plane;
}

/// By very many places, so that jumps are where they are to within 1e-3.
Mix counted(const Ramp& ramp, const RampPlane& plane, double width) {
  constexpr int kSide = 700;
  Mix sum{0.0};
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double shift = double((j * 7919 + i * 104729) % 997) / 997 - 0.5;
      sum += ramp.color(plane.at(width * ((i + 0.5 + shift) / kSide - 0.5),
                                 width * ((j + 0.5 - shift) / kSide - 0.5)));
    }
  return sum / double(kSide * kSide);
}

TEST(RampIntegral, GivesMeansOverBoxes) {
  Random r(1);
  for (int i = 0; i < 40; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const RampPlane plane = random_plane(r, ramp);
    const double width = i % 2 ? 1.0 : 0.25;
    const Mix mean = integral.box_mean(integral.scaled(plane), width);
    ASSERT_LT(largest(mean - counted(ramp, plane, width)), 1e-3) << i;
  }
}

TEST(RampIntegral, GivesIntegralsBesideChords) {
  Random r(2);
  for (int i = 0; i < 60; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const RampPlane plane = random_plane(r, ramp), scaled = integral.scaled(plane);
    const double xa = r.between(-0.5, 0.5), xb = r.between(-0.5, 0.5), ya = r.between(-0.5, 0.3),
                 yb = ya + std::pow(10, r.between(-3, -0.8));
    Mix sum{0.0};
    constexpr int kRows = 1500;
    for (int j = 0; j < kRows; ++j) {
      const double v = (j + 0.5) / kRows, x = xa + v * (xb - xa), y = ya + v * (yb - ya);
      constexpr int kColumns = 300;
      for (int k = 0; k < kColumns; ++k) {
        const double u = (k + double(j * 7919 % 997) / 997) / kColumns;
        sum += (0.5 - x) / kColumns / kRows *
               (ramp.color(plane.at(x + u * (0.5 - x), y)) - integral.mean());
      }
    }
    const Mix got = integral.right_of(scaled, xa, ya, xb, yb, 0.5);
    ASSERT_LT(largest(got - (yb - ya) * sum), 5e-4) << i;
  }
}

TEST(RampIntegral, KnowsThePeriodsMean) {
  const Gradient stripes{
      LinearGradient{},
      {{0, {0, 0, 0, 1}}, {0.75, {0, 0, 0, 1}}, {0.75, {1, 1, 1, 1}}, {1, {1, 1, 1, 1}}},
      Extend::repeat};
  RampIntegral integral;
  integral.make(Ramp(stripes, 1, Blend::linear));
  EXPECT_NEAR(integral.mean().r, 0.25, 1e-15);
  EXPECT_EQ(integral.period(), 1.0);
  // Ever more periods in a box; and as exact far from the first stop.
  for (const double across : {1.0, 10.0, 1e6, 1e9})
    EXPECT_NEAR(integral.box_mean(integral.scaled({0.3, across, 0.0}), 1.0).r, 0.25, 1e-6);
  const auto near = integral.box_mean(integral.scaled({0.3, 0.4, 0.5}), 1.0),
             far = integral.box_mean(integral.scaled({0.3 + 1e7, 0.4, 0.5}), 1.0);
  EXPECT_NEAR(near.r, far.r, 1e-7);
  EXPECT_GT(std::abs(near.r - 0.25), 0.01);
}

TEST(RampIntegral, OfStopsThatAreNoPlacesIsOfTheOthers) {
  const Color black{0, 0, 0, 1}, white{1, 1, 1, 1};
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    RampIntegral integral;
    integral.make(Ramp({LinearGradient{}, {{0, black}, {odd, white}, {1, white}}}, 1, Blend::srgb));
    EXPECT_NEAR(integral.box_mean(integral.scaled({0.5, 0.5, 0.2}), 1.0).r, 0.5, 1e-12);
  }
  // Out of order, all at one place, next to none at all, and as far apart as can be.
  for (const double last : {-3.0, 0.0, 1e-300, 1e308}) {
    RampIntegral integral;
    integral.make(
        Ramp({LinearGradient{}, {{last < 1 ? 0 : -1e308, black}, {last, white}}}, 1, Blend::srgb));
    for (const double t : {-1.0, 0.0, 1.0, 1e300, -1e308})
      EXPECT_TRUE(std::isfinite(integral.box_mean(integral.scaled({t, 0.5, 0.2}), 1.0).r))
          << last << ' ' << t;
    EXPECT_NEAR(integral.box_mean(integral.scaled({0.0, 0.5, 0.2}), 1.0).r, 0.5, 1e-6);
  }
}

TEST(RampIntegral, GivesARowTheMeansOfItsPixels) {
  Random r(5);
  for (int i = 0; i < 200; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const RampPlane plane = integral.scaled(random_plane(r, ramp));
    std::array<Mix, 20> row, part;
    integral.row_means(plane, 64, 9, row);
    integral.row_means(plane, 71, 9, std::span(part).first(5));
    for (std::size_t k = 0; k < row.size(); ++k) {
      const RampPlane own{plane.at(64.5 + double(k), 9.5), plane.gx, plane.gy};
      ASSERT_NEAR(row[k].r, integral.box_mean(own, 1.0).r, 1e-5) << i << ' ' << k;
    }
    for (std::size_t k = 0; k < 5; ++k) ASSERT_EQ(part[k], row[7 + k]);  // wherever a run begins
  }
}

}  // namespace
}  // namespace mien::test
