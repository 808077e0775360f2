#include <mien/quad_bezier_distance.h>

#include <gtest/gtest.h>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/bezier_cases.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

class QuadBezierFamily : public testing::TestWithParam<int> {};

TEST_P(QuadBezierFamily, DistanceIsExact) {  // E7: collinear and coincident points too
  Random r(100 + GetParam());
  WorstError worst;
  for (int i = 0; i < times(20'000); ++i) {
    const BezierCase c = bezier_case(BezierFamily(GetParam()), r);
    const double d = distance(c.curve, c.p);
    worst.note(c.p, d, double(exact_distance(c.curve, c.p) - Real(d)), test::reach(c.curve, c.p));
    const NearestPoint n = nearest(c.curve, c.p);
    EXPECT_EQ(n.distance, d);
    EXPECT_TRUE(n.t >= 0 && n.t <= 1);
    EXPECT_NEAR(norm(n.point - c.p), d, 8 * 0x1p-52 * (test::reach(c.curve, c.p) + norm(c.p)));
    EXPECT_NEAR(norm(n.point - on(c.curve, n.t)), 0,
                8 * 0x1p-52 * (norm(c.p) + test::reach(c.curve, c.p)));
  }
  EXPECT_LE(worst.units, QuadBezierContract::kError / 0x1p-52) << worst;
  RecordProperty("worst", std::to_string(worst.units));
}
INSTANTIATE_TEST_SUITE_P(AllFamilies, QuadBezierFamily,
                         testing::Range(0, int(BezierFamily::count)));

TEST(QuadBezier, FixturesThatOtherSolversMissed) {
  for (const BezierFixture& f : kBezierFixtures) {
    const double d = distance(f.at.curve, f.at.p);
    EXPECT_NEAR(d, f.distance, 5e-4 * f.distance);
    EXPECT_NEAR(double(Real(d) - exact_distance(f.at.curve, f.at.p)), 0,
                4 * 0x1p-52 * test::reach(f.at.curve, f.at.p));
  }
}

TEST(QuadBezier, KnownDistances) {
  const QuadBezier arch{{-1, 0}, {0, 2}, {1, 0}};  // y = 1 − x²
  EXPECT_EQ(distance(arch, {0, 1}), 0);
  EXPECT_EQ(distance(arch, {0, 3}), 2);
  EXPECT_DOUBLE_EQ(distance(arch, {0, 0}), std::sqrt(0.75));
  EXPECT_EQ(distance(arch, {1, -3}), 3);
  EXPECT_EQ(distance(QuadBezier{{0, 0}, {0, 0}, {0, 0}}, {3, 4}), 5);
  EXPECT_EQ(distance(QuadBezier{{1, 1}, {1, 1}, {1, 1}}, {1, 1}), 0);
  EXPECT_EQ(distance(QuadBezier{{0, 0}, {2, 0}, {0, 0}}, {3, 0}), 2);  // turns back at 1
}

TEST(QuadBezier, EveryStationaryParameterIsFound) {
  Random r(1);
  int three = 0;
  for (int i = 0; i < times(20'000); ++i) {
    const BezierCase c = bezier_case(BezierFamily::random, r);
    std::vector<Real> exact;
    exact_distance(c.curve, c.p, &exact);
    const CriticalPoints found = critical_points(c.curve, c.p);
    ASSERT_EQ(found.count, int(exact.size()));
    for (int k = 0; k < found.count; ++k) EXPECT_NEAR(found.t[k], double(exact[k]), 1e-9);
    three += found.count == 3;
  }
  EXPECT_GT(three, times(100));
}

TEST(QuadBezier, AnySizeGivesAnAnswer) {
  for (const double k : {1e-320, 1e-300, 1e-160, 1e160, 1e300}) {
    const QuadBezier arch{{-k, 0}, {0, 2 * k}, {k, 0}};
    EXPECT_NEAR(distance(arch, {0, 3 * k}) / k, 2, 1e-3) << k;
    EXPECT_EQ(nearest(arch, {0, 3 * k}).t, 0.5) << k;
  }
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const QuadBezier arch{{-1, 0}, {0, 2}, {1, 0}};
  for (const double bad : {inf, -inf, nan}) {
    EXPECT_EQ(distance(arch, {0, bad}), inf);
    EXPECT_EQ(distance(arch, {bad, 0}), inf);
    EXPECT_EQ(distance(QuadBezier{{0, 0}, {1, bad}, {0, 1}}, {0, 0}), inf);
    EXPECT_EQ(distance(QuadBezier{{0, 0}, {1, 1}, {bad, 1}}, {0, 0}), inf);
    EXPECT_EQ(nearest(arch, {bad, bad}).distance, inf);
    EXPECT_EQ(critical_points(arch, {bad, 0}).count, 0);
  }
}

TEST(QuadBezier, MirroredAndReversed) {
  Random r(2);
  for (int i = 0; i < times(20'000); ++i) {
    const BezierCase c = bezier_case(BezierFamily(i % int(BezierFamily::tiny)), r);
    const double d = distance(c.curve, c.p);
    const auto mirror = [](glm::dvec2 v) { return glm::dvec2(-v.x, v.y); };
    EXPECT_EQ(distance(QuadBezier{mirror(c.curve.p0), mirror(c.curve.p1), mirror(c.curve.p2)},
                       mirror(c.p)),
              d);
    EXPECT_NEAR(distance(reversed(c.curve), c.p), d, 8 * 0x1p-52 * test::reach(c.curve, c.p));
  }
}

TEST(QuadBezier, BoundsAndCurvature) {
  const QuadBezier arch{{-1, 0}, {0, 2}, {1, 0}};
  const Box2 box = bounds(arch);
  EXPECT_EQ(box.lo, glm::dvec2(-1, 0));
  EXPECT_NEAR(box.hi.y, 1, 1e-15);
  EXPECT_GE(box.hi.y, 1);
  EXPECT_DOUBLE_EQ(smallest_curvature_radius(arch), 0.5);
  EXPECT_EQ(smallest_curvature_radius({{0, 0}, {1, 0}, {2, 0}}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(smallest_curvature_radius({{0, 0}, {2, 0}, {0, 0}}), 0);
  Random r(4);
  for (int i = 0; i < times(1000); ++i) {
    const QuadBezier c{r.point(-1, 1), r.point(-1, 1), r.point(-1, 1)};
    const Box2 b = bounds(c);
    for (double t = 0; t <= 1; t += 0.01) EXPECT_TRUE(b.contains(on(c, t)));
  }
}

}  // namespace
}  // namespace mien::test
