#include <mien/tapered_stroke.h>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/bezier_cases.h"
#include "tests/support/shapes/shape_examples/tapered_stroke.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

/// Every root of (q·q')² = w'²|q|² and both ends, in binary128.
Real exact_distance(const TaperedStroke& s, glm::dvec2 p) {
  const auto bernstein = [](Real a, Real b, Real c) {
    return Polynomial{a, 2 * (b - a), (c - b) - (b - a)};
  };
  const QuadBezier& c = s.spine;
  const Polynomial x = bernstein(Real(c.p0.x) - p.x, Real(c.p1.x) - p.x, Real(c.p2.x) - p.x);
  const Polynomial y = bernstein(Real(c.p0.y) - p.y, Real(c.p1.y) - p.y, Real(c.p2.y) - p.y);
  const Polynomial w = bernstein(s.half_width[0], s.half_width[1], s.half_width[2]);
  const Polynomial along = x * derivative(x) + y * derivative(y), squared = x * x + y * y,
                   dw = derivative(w);
  std::vector<Real> t = roots_in(along * along + Real(-1) * (dw * dw * squared), 0, 1);
  for (const Real u : roots_in(along, 0, 1)) t.push_back(u);
  for (const Real u : roots_in(dw, 0, 1)) t.push_back(u);  // a spine of no length
  t.push_back(0);
  t.push_back(1);
  Real best = 0;
  bool first = true;
  for (const Real u : t) {
    const Real d = sqrt(value(squared, u)) - value(w, u);
    if (first || d < best) best = d;
    first = false;
  }
  return best;
}

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(TaperedStroke, ShapeLaws, TaperedStroke);

class TaperedStrokeFamily : public testing::TestWithParam<int> {};

TEST_P(TaperedStrokeFamily, DistanceIsExact) {  // E6
  Random r(300 + GetParam());
  WorstError worst;
  for (int i = 0; i < times(1500); ++i) {
    const BezierCase c = bezier_case(BezierFamily(GetParam()), r);
    const double length =
        std::max({norm(c.curve.p1 - c.curve.p0), norm(c.curve.p2 - c.curve.p1), 1e-9});
    TaperedStroke s{c.curve, {}};
    for (double& w : s.half_width)
      w = length * (r.chance(0.2) ? 0 : r.chance(0.5) ? r.size(-6, 0.5) : r.unit());
    if (r.chance(0.1)) s.half_width[2] = s.half_width[1] = s.half_width[0];
    if (r.chance(0.1)) s.half_width[1] = 0.5 * (s.half_width[0] + s.half_width[2]);
    if (r.chance(0.1))
      s.half_width[2] =
          s.half_width[0] + norm(c.curve.p2 - c.curve.p0);  // discs that just touch inside
    const double d = distance(s, c.p);
    const double size =
        reach(c.curve, c.p) + std::max({s.half_width[0], s.half_width[1], s.half_width[2]});
    worst.note(c.p, d, double(exact_distance(s, c.p) - Real(d)), size);
  }
  EXPECT_LE(worst.units, TaperedStrokeContract::kError / 0x1p-52) << worst;
  RecordProperty("worst", std::to_string(worst.units));
}
INSTANTIATE_TEST_SUITE_P(AllFamilies, TaperedStrokeFamily,
                         testing::Range(0, int(BezierFamily::count)));

TEST(TaperedStroke, OfOneWidthIsTheStroke) {
  Random r(9);
  for (int i = 0; i < times(2000); ++i) {
    const BezierCase c = bezier_case(BezierFamily::random, r);
    const double w = r.unit();
    EXPECT_NEAR(distance(TaperedStroke{c.curve, {w, w, w}}, c.p),
                distance(QuadStroke{c.curve, w}, c.p), 1e-15);
  }
}

TEST(TaperedStroke, AConeIsItsTangents) {
  // Discs of radius t/2 at (t, 0): straight sides at 30° that touch the largest disc.
  const TaperedStroke cone{{{0, 0}, {0.5, 0}, {1, 0}}, {0, 0.25, 0.5}};
  const glm::dvec2 normal{-0.5, std::sqrt(0.75)};
  EXPECT_NEAR(distance(cone, 0.5 * glm::dvec2(std::sqrt(0.75), 0.5) + 2.0 * normal), 2, 1e-15);
  EXPECT_DOUBLE_EQ(distance(cone, {-3, 0}), 3);
  EXPECT_DOUBLE_EQ(distance(cone, {2.5, 0}), 1);
  EXPECT_DOUBLE_EQ(distance(cone, {1, 0}), -0.5);
}

TEST(TaperedStroke, AnySizeGivesAnAnswer) {
  for (const double k : {1e-300, 1e-160, 1e160, 1e300}) {
    const TaperedStroke s{{{-k, 0}, {0, 0}, {k, 0}}, {0.1 * k, 0.1 * k, 0.2 * k}};
    EXPECT_NEAR(distance(s, {3 * k, 0}) / k, 1.8, 1e-12);
  }
  EXPECT_EQ(distance(TaperedStroke{{{1, 1}, {1, 1}, {1, 1}}, {0, 0, 0}}, {1, 1}), 0);
}

}  // namespace mien::test
