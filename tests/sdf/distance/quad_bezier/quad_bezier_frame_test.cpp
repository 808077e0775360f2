#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace mien::batch {
namespace {

const QuadBezier kFramed{{0.3, 0.1}, {0.9, 0.4}, {0.2, 1.1}};

/// x³ + 3 P x − S2 at x = t + vertex must be the slope of |B(t) − p|², up to the factor |b|².
TEST(QuadBezierFrame, ItsCubicIsTheSlopeOfTheSquaredDistance) {
  const auto f = quad_bezier_frame<double>(kFramed, 0);
  for (const glm::dvec2 p : {glm::dvec2{0.5, 0.5}, {-1, 2}, {0.3, 0.1}}) {
    const glm::dvec2 d = kFramed.p0 - p;
    const double big_p = f.px * d.x + f.py * d.y + f.p1, s2 = f.sx * d.x + f.sy * d.y + f.s1;
    for (const double t : {-0.7, 0.0, 0.3, 1.0, 2.5}) {
      const double x = t + f.vertex;
      const double slope = glm::dot(point(kFramed, t) - p, tangent(kFramed, t)) / 2;
      EXPECT_NEAR((x * x + 3 * big_p) * x - s2, slope / (f.bx * f.bx + f.by * f.by), 1e-12);
    }
  }
}

TEST(QuadBezierFrame, ScaleBringsTheLargerLegBetweenAHalfAndOne) {
  for (const double size : {1e-30, 1e-3, 1.0, 7.0, 1e20}) {
    const QuadBezier c{kFramed.p0 * size, kFramed.p1 * size, kFramed.p2 * size};
    const auto f = quad_bezier_frame<float>(c, *scale_exponent(c));
    const glm::dvec2 a = glm::abs(c.p1 - c.p0), b = glm::abs(c.p2 - c.p1);
    const double leg = std::max({a.x, a.y, b.x, b.y}) * f.scale;
    EXPECT_GE(leg, 0.5) << size;
    EXPECT_LT(leg, 1.0) << size;
    EXPECT_EQ(f.scale * f.unscale, 1);
  }
}

TEST(QuadBezierFrame, StraightCurvesArePointedOut) {
  const auto straight = [](double off) {
    const QuadBezier c{{0, 0}, {0.5, off}, {1, 0}};
    return quad_bezier_frame<float>(c, *scale_exponent(c)).straight;
  };
  EXPECT_TRUE(straight(0));
  EXPECT_TRUE(straight(0.003));
  EXPECT_FALSE(straight(0.005));
}

TEST(QuadBezierFrame, PointsAndNonsenseHaveNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(scale_exponent(kFramed));
  EXPECT_FALSE(scale_exponent({{1, 2}, {1, 2}, {1, 2}}));
  EXPECT_FALSE(scale_exponent({{nan, 2}, {1, 2}, {1, 3}}));
  EXPECT_FALSE(scale_exponent({{0, 2}, {1, 2}, {inf, 3}}));
}

}  // namespace
}  // namespace mien::batch
