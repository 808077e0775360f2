#include "sdf/distance/tapered/tapered_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien::batch {
namespace {

const QuadBezier kSpine{{0.3, 0.1}, {0.9, 0.4}, {0.2, 1.1}};

/// x³ + 3 P x − S2 at x = t + vertex is the slope of |q|² − (w + L)², up to a factor.
TEST(TaperedFrame, ItsCubicIsTheSlopeOfTheSquareLessTheWidths) {
  const TaperedStroke s{kSpine, {0.1, 0.3, 0.05}};
  const auto f = tapered_frame<float>(s);
  ASSERT_TRUE(f);
  const double k = f->spine.scale;
  for (const glm::dvec2 p : {glm::dvec2{0.5, 0.5}, {-1, 2}, {0.3, 0.1}})
    for (const double level : {-0.2, 0.0, 0.7}) {
      const glm::dvec2 d = k * (kSpine.p0 - p);
      const double big_p = f->px * d.x + f->py * d.y + f->pw * level + f->p1;
      const double s2 = f->sx * d.x + f->sy * d.y + f->sw * level + f->s1;
      double factor = 0;
      for (const double t : {0.0, 0.3, 1.0, 2.5, -0.7}) {
        const double u = 1 - t, x = t + f->vertex;
        const double w = k * (u * u * 0.1 + 2 * u * t * 0.3 + t * t * 0.05);
        const double rate = k * 2 * (u * 0.2 - t * 0.25);
        const double slope =
            k * k * glm::dot(point(kSpine, t) - p, tangent(kSpine, t)) - (w + level) * rate;
        const double cubic = (x * x + 3 * big_p) * x - s2;
        if (factor == 0) factor = cubic / slope;
        EXPECT_NEAR(cubic, factor * slope, 2e-5 * (1 + std::abs(cubic)));
      }
    }
}

TEST(TaperedFrame, WhatIsStraightOrWiderThanLongHasNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tapered_frame<float>({{{0, 0}, {0.5, 0}, {1, 0}}, {0.1, 0.2, 0.1}}));
  EXPECT_FALSE(tapered_frame<float>({{{1, 1}, {1, 1}, {1, 1}}, {0.1, 0.2, 0.1}}));
  EXPECT_FALSE(tapered_frame<float>({kSpine, {0.1, nan, 0.1}}));
  EXPECT_FALSE(tapered_frame<float>({kSpine, {0, 3, 0}}));  // the width bends more than the spine
  EXPECT_TRUE(tapered_frame<float>({kSpine, {0, 0, 0}}));
}

}  // namespace
}  // namespace mien::batch
