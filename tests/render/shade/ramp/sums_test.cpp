#include "render/shade/ramp/sums.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/random/random.h"
#include "tests/support/random/random_ramp.h"

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

Mix box_mean(const RampIntegral& ramp, const RampPlane& plane, double width = 1.0) {
  RampBoxes boxes{{ramp.scaled(plane)}, {{1, width}}};
  ColorRow row;
  ramp_means(ramp, boxes, row, 0);
  return {row.r[0], row.g[0], row.b[0], row.a[0]};
}

TEST(RampSums, GiveMeansOverBoxes) {
  Random r(1);
  for (int i = 0; i < 40; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const RampPlane plane = random_plane(r, ramp);
    const double width = i % 2 ? 1.0 : 0.25;
    const Mix mean = box_mean(integral, plane, width);
    ASSERT_LT(largest(mean - counted(ramp, plane, width)), 1e-3) << i;
  }
}

TEST(RampSums, KnowThePeriodsMean) {
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
    EXPECT_NEAR(box_mean(integral, {0.3, across, 0.0}).r, 0.25, 1e-6);
  const auto near = box_mean(integral, {0.3, 0.4, 0.5}),
             far = box_mean(integral, {0.3 + 1e7, 0.4, 0.5});
  EXPECT_NEAR(near.r, far.r, 1e-7);
  EXPECT_GT(std::abs(near.r - 0.25), 0.01);
}

TEST(RampSums, OfStopsThatAreNoPlacesAreOfTheOthers) {
  const Color black{0, 0, 0, 1}, white{1, 1, 1, 1};
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    RampIntegral integral;
    integral.make(Ramp({LinearGradient{}, {{0, black}, {odd, white}, {1, white}}}, 1, Blend::srgb));
    EXPECT_NEAR(box_mean(integral, {0.5, 0.5, 0.2}).r, 0.5, 1e-12);
  }
  // Out of order, all at one place, next to none at all, and as far apart as can be.
  for (const double last : {-3.0, 0.0, 1e-300, 1e308}) {
    RampIntegral integral;
    integral.make(
        Ramp({LinearGradient{}, {{last < 1 ? 0 : -1e308, black}, {last, white}}}, 1, Blend::srgb));
    for (const double t : {-1.0, 0.0, 1.0, 1e300, -1e308})
      EXPECT_TRUE(std::isfinite(box_mean(integral, {t, 0.5, 0.2}).r)) << last << ' ' << t;
    EXPECT_NEAR(box_mean(integral, {0.0, 0.5, 0.2}).r, 0.5, 1e-6);
  }
}

TEST(RampSums, FindTheirPiecesAmongUnevenOnes) {
  Random r(3);
  for (int i = 0; i < 100; ++i) {
    Gradient g{LinearGradient{}, {}, Extend(i % 3)};
    const int count = int(r.between(2, 60));
    double at = 0;
    // Some lie close together, many in one bucket.
    for (int k = 0; k < count; ++k, at += std::pow(10, r.between(-6, 0)))
      g.stops.push_back({at, {r.between(0, 1), r.between(0, 1), r.between(0, 1), 1}});
    const Ramp ramp(g, 1, Blend::srgb);
    RampIntegral integral;
    integral.make(ramp);
    for (int k = 0; k < 100; ++k) {
      const double t = r.between(-1, 2) * at;
      Mix mean{0.0};
      constexpr int kPlaces = 4000;
      const double width = 1e-3 * at;
      for (int n = 0; n < kPlaces; ++n)
        mean += ramp.color(t + ((n + 0.5) / kPlaces - 0.5) * width) / double(kPlaces);
      ASSERT_LT(largest(box_mean(integral, {t, width, 0.0}) - mean), 1e-3) << i << ' ' << t;
    }
  }
}

TEST(RampSums, OfARowAreThoseOfItsPixels) {
  Random r(5);
  for (int i = 0; i < 200; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const RampPlane by_t = random_plane(r, ramp), plane = integral.scaled(by_t);
    RampRows rows, others;
    ColorRow row, part;
    for (const int y : {9, 10, 40}) {  // of neighbours half is known
      rows.means(integral, plane, 64, y, 10, row);
      rows.means(integral, plane, 74, y, 10, row);
      others.means(integral, plane, 76, y, 5, part);
      for (std::size_t k = 0; k < 10; ++k) {
        const RampPlane own{by_t.at(74.5 + double(k), y + 0.5), by_t.gx, by_t.gy};
        ASSERT_NEAR(row.r[k], box_mean(integral, own).r, 1e-5) << i << ' ' << k;
      }
      for (std::size_t k = 0; k < 5; ++k)  // wherever a run begins
        ASSERT_EQ(part.r[k], row.r[2 + k]) << i << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace mien::test
