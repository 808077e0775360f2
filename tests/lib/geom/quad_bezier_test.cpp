#include <gtest/gtest.h>
#include <mien/quad_bezier.h>

namespace mien {
namespace {

constexpr QuadBezier kCurve{{0.44, 0.35}, {0.17, 0.52}, {0.03, 0.41}};

TEST(QuadBezier, BeginsAndEndsAtItsEndPoints) {
  EXPECT_EQ(point(kCurve, 0.0), kCurve.p0);
  EXPECT_NEAR(point(kCurve, 1.0).x, kCurve.p2.x, 1e-15);
  EXPECT_NEAR(point(kCurve, 1.0).y, kCurve.p2.y, 1e-15);
}

TEST(QuadBezier, IsTheWeightedMeanOfItsControlPoints) {
  for (const double t : {0.1, 0.25, 0.5, 0.9}) {
    const double s = 1 - t;
    const glm::dvec2 mean = s * s * kCurve.p0 + 2 * s * t * kCurve.p1 + t * t * kCurve.p2;
    EXPECT_NEAR(point(kCurve, t).x, mean.x, 1e-15);
    EXPECT_NEAR(point(kCurve, t).y, mean.y, 1e-15);
  }
}

TEST(QuadBezier, TangentAndBendAreItsDerivatives) {
  const double h = 1e-3;  // of a quadratic, central differences are exact to rounding
  for (const double t : {0.0, 0.3, 1.0}) {
    const glm::dvec2 rise = (point(kCurve, t + h) - point(kCurve, t - h)) / (2 * h);
    EXPECT_NEAR(tangent(kCurve, t).x, rise.x, 1e-12);
    EXPECT_NEAR(tangent(kCurve, t).y, rise.y, 1e-12);
    const glm::dvec2 turn = (tangent(kCurve, t + h) - tangent(kCurve, t - h)) / (2 * h);
    EXPECT_NEAR(bend(kCurve).x, turn.x, 1e-12);
    EXPECT_NEAR(bend(kCurve).y, turn.y, 1e-12);
  }
}

TEST(QuadBezier, ReversedRunsTheOtherWay) {
  for (const double t : {0.0, 0.2, 0.7}) {
    EXPECT_NEAR(point(reversed(kCurve), t).x, point(kCurve, 1 - t).x, 1e-15);
    EXPECT_NEAR(point(reversed(kCurve), t).y, point(kCurve, 1 - t).y, 1e-15);
  }
}

}  // namespace
}  // namespace mien
