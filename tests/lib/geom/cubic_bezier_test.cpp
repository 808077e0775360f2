#include <mien/cubic_bezier.h>

#include <gtest/gtest.h>

namespace mien::test {

TEST(CubicBezierCurve, PointsTangentsAndKin) {
  const CubicBezier c{{0, 0}, {0, 3}, {3, 3}, {3, 0}};
  EXPECT_EQ(point(c, 0), glm::dvec2(0, 0));
  EXPECT_EQ(point(c, 1), glm::dvec2(3, 0));
  EXPECT_EQ(point(c, 0.5), glm::dvec2(1.5, 2.25));
  EXPECT_EQ(tangent(c, 0), glm::dvec2(0, 9));
  EXPECT_EQ(tangent(c, 0.5), glm::dvec2(4.5, 0));
  EXPECT_EQ(point(reversed(c), 0.25), point(c, 0.75));
  const QuadBezier q{{0, 0}, {1, 3}, {2, 1}};
  for (double t = 0; t <= 1; t += 0.125) {
    EXPECT_NEAR(point(elevated(q), t).x, point(q, t).x, 1e-15);
    EXPECT_NEAR(point(elevated(q), t).y, point(q, t).y, 1e-15);
  }
}

}  // namespace mien::test
