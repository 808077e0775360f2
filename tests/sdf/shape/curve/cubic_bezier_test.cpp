#include <mien/cubic_bezier_distance.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/bezier_cases.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

struct CubicCase {
  CubicBezier curve;
  glm::dvec2 p;
};

enum class Family {
  random,
  on_curve,
  near_curve,
  evolute,
  cusp,
  loop,
  collinear,
  nearly_collinear,
  coincident,
  elevated,
  far,
  offset,
  count
};

CubicCase cubic_case(Family family, Random& r) {
  CubicBezier c{r.point(0, 1), r.point(0, 1), r.point(0, 1), r.point(0, 1)};
  glm::dvec2 p = r.point(0, 1);
  const auto off = [&] { return r.chance(0.25) ? glm::dvec2(0) : r.size(-16, -2) * r.direction(); };
  const double t = r.unit();
  switch (family) {
    case Family::on_curve:
      p = point(c, t);
      break;
    case Family::near_curve:
      p = point(c, t) + off();
      break;
    case Family::evolute: {
      const double h = 1e-5, u = 0.1 + 0.8 * t;
      const glm::dvec2 v = tangent(c, u), a = (tangent(c, u + h) - tangent(c, u - h)) / (2 * h);
      p = point(c, u) + (v.x * v.x + v.y * v.y) / (v.x * a.y - v.y * a.x) * glm::dvec2(-v.y, v.x) +
          off();
      break;
    }
    case Family::cusp:  // B'(1/2) = 0: p1 + p2 fixed by p3 − p0 …
      c = {{0, 0}, {1, 1}, {0, 1}, {1, 0}};
      p = glm::dvec2(0.5, 0.75) + off();
      break;
    case Family::loop:
      c = {{0, 0}, {1.5 + t, 1}, {-0.5 - t, 1}, {1, 0}};
      if (r.chance(0.5)) p = point(c, r.unit()) + off();
      break;
    case Family::collinear: {
      const glm::dvec2 v = 0x1p-10 * glm::dvec2(r.below(7) - 3, r.below(7) - 3);
      const auto any = [&] { return double(r.below(1024)) * v; };
      c = {any(), any(), any(), any()};
      if (r.chance(0.3)) p = point(c, t);
      break;
    }
    case Family::nearly_collinear: {
      const glm::dvec2 chord = c.p3 - c.p0, across{-chord.y, chord.x};
      c.p1 = c.p0 + r.between(-0.5, 1.5) * chord + r.size(-16, -3) * across;
      c.p2 = c.p0 + r.between(-0.5, 1.5) * chord + r.size(-16, -3) * across;
      if (r.chance(0.3)) p = point(c, t) + off();
      break;
    }
    case Family::coincident:
      switch (r.below(6)) {
        case 0:
          c.p1 = c.p0;
          break;
        case 1:
          c.p2 = c.p3;
          break;
        case 2:
          c.p2 = c.p1;
          break;
        case 3:
          c.p1 = c.p0, c.p2 = c.p3;
          break;
        case 4:
          c.p3 = c.p0;
          break;
        default:
          c.p1 = c.p2 = c.p3 = c.p0;
          break;
      }
      break;
    case Family::elevated: {
      const BezierCase quad = bezier_case(BezierFamily(r.below(int(BezierFamily::far))), r);
      c = elevated(quad.curve);
      p = quad.p;
      break;
    }
    case Family::far:
      p = r.size(2, 9) * r.direction();
      break;
    case Family::offset: {
      const glm::dvec2 by = r.size(2, 6) * r.direction();
      c = {c.p0 + by, c.p1 + by, c.p2 + by, c.p3 + by};
      p += by;
      break;
    }
    default:
      break;
  }
  if (!(norm(p) < 1e12)) p = {0.5, 0.5};
  return {c, p};
}

Real exact_cubic_distance(const CubicBezier& c, glm::dvec2 p) {
  const auto monomial = [](Real a, Real b, Real d, Real e) {
    return Polynomial{a, 3 * (b - a), 3 * (d - 2 * b + a), e - 3 * d + 3 * b - a};
  };
  const Polynomial x =
      monomial(Real(c.p0.x) - p.x, Real(c.p1.x) - p.x, Real(c.p2.x) - p.x, Real(c.p3.x) - p.x);
  const Polynomial y =
      monomial(Real(c.p0.y) - p.y, Real(c.p1.y) - p.y, Real(c.p2.y) - p.y, Real(c.p3.y) - p.y);
  std::vector<Real> t = roots_in(x * derivative(x) + y * derivative(y), 0, 1);
  t.push_back(0);
  t.push_back(1);
  Real best = -1;
  for (const Real u : t) {
    const Real squared = value(x, u) * value(x, u) + value(y, u) * value(y, u);
    if (best < 0 || squared < best) best = squared;
  }
  return sqrt(best);
}

double cubic_reach(const CubicBezier& c, glm::dvec2 p) {
  return std::max({norm(c.p0 - p), norm(c.p1 - p), norm(c.p2 - p), norm(c.p3 - p)});
}

class CubicBezierFamily : public testing::TestWithParam<int> {};

TEST_P(CubicBezierFamily, DistanceIsExact) {
  Random r(500 + GetParam());
  WorstError worst;
  for (int i = 0; i < times(1500); ++i) {
    const CubicCase c = cubic_case(Family(GetParam()), r);
    const NearestPoint n = nearest(c.curve, c.p);
    EXPECT_EQ(distance(c.curve, c.p), n.distance);
    EXPECT_NEAR(norm(point(c.curve, n.t) - c.p), n.distance,
                8 * 0x1p-52 * (cubic_reach(c.curve, c.p) + norm(c.p)));
    worst.note(c.p, n.distance, double(exact_cubic_distance(c.curve, c.p) - Real(n.distance)),
               cubic_reach(c.curve, c.p));
  }
  EXPECT_LE(worst.units, CubicBezierContract::kError / 0x1p-52) << worst;
  RecordProperty("worst", std::to_string(worst.units));
}
INSTANTIATE_TEST_SUITE_P(AllFamilies, CubicBezierFamily, testing::Range(0, int(Family::count)));

TEST(CubicBezier, OfAQuadraticIsTheQuadratic) {
  Random r(1);
  for (int i = 0; i < times(5000); ++i) {
    const BezierCase c = bezier_case(BezierFamily::random, r);
    EXPECT_NEAR(distance(elevated(c.curve), c.p), distance(c.curve, c.p), 1e-14);
    EXPECT_NEAR(distance(reversed(elevated(c.curve)), c.p), distance(c.curve, c.p), 1e-14);
  }
}

TEST(CubicBezier, AnySizeGivesAnAnswer) {
  for (const double k : {1e-310, 1e-160, 1.0, 1e160, 1e300}) {
    const CubicBezier arch{{-k, 0}, {-k, 4 * k / 3}, {k, 4 * k / 3}, {k, 0}};  // top at y = k
    EXPECT_NEAR(distance(arch, {0, 3 * k}) / k, 2, 1e-3) << k;
  }
  const double inf = std::numeric_limits<double>::infinity();
  const CubicBezier arch{{-1, 0}, {-1, 1}, {1, 1}, {1, 0}};
  for (const double bad : {inf, -inf, std::nan("")}) {
    EXPECT_EQ(distance(arch, {bad, 0}), inf);
    EXPECT_EQ(distance(CubicBezier{{0, 0}, {1, 1}, {2, bad}, {3, 0}}, {0, 0}), inf);
  }
}

TEST(CubicBezier, MirrorImagesAgreeToTheBit) {
  Random r(2);
  for (int i = 0; i < times(5000); ++i) {
    const CubicCase c = cubic_case(Family(i % int(Family::count)), r);
    const auto m = [](glm::dvec2 v) { return glm::dvec2(-v.x, v.y); };
    EXPECT_EQ(
        distance(CubicBezier{m(c.curve.p0), m(c.curve.p1), m(c.curve.p2), m(c.curve.p3)}, m(c.p)),
        distance(c.curve, c.p));
  }
}

}  // namespace
}  // namespace mien::test
