#include <mien/cubic_roots.h>

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/exact/real128.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

struct Cubic {
  double a, b, c, d;

  Polynomial exact() const { return {d, c, b, a}; }
  double size(double x) const {  // the terms' absolute sum
    const double y = std::abs(x);
    return ((std::abs(a) * y + std::abs(b)) * y + std::abs(c)) * y + std::abs(d);
  }
};

/// a (x − r)(x − s)(x − t), rounded.
Cubic from_roots(Real a, Real r, Real s, Real t) {
  const Polynomial f = a * (Polynomial{-r, 1} * Polynomial{-s, 1} * Polynomial{-t, 1});
  return {double(f[3]), double(f[2]), double(f[1]), double(f[0])};
}

/// A root whose sign change does not survive a relative change of the coefficients by `units` ulp
/// may be missed, and only there may one be found that is none.
constexpr double kRobust = 16 * 0x1p-52;

struct Outcome {
  double worst = 0;  ///< backward error in 2⁻⁵² of the terms' sum
  int missed = 0, invented = 0, disordered = 0;
};

void judge(const Cubic& f, Outcome& outcome) {
  const Roots found = solve_cubic(f.a, f.b, f.c, f.d);
  const Polynomial exact = f.exact(), slope = derivative(exact);
  for (int i = 0; i < found.count; ++i) {
    if (i > 0 && !(found.x[i - 1] < found.x[i])) ++outcome.disordered;
    const double error = double(abs(value(exact, found.x[i]))) / (0x1p-52 * f.size(found.x[i]));
    // A double root is taken at the critical point, a triple one at the inflection.
    outcome.worst = std::max(outcome.worst, error);
    if (!(error <= 16)) ++outcome.invented;
  }
  // Robust roots: between neighbouring turns where the exact cubic differs in sign by more than
  // rounding.
  std::vector<Real> knots{-Real(1e300)};
  for (const Real m : real_roots(slope)) knots.push_back(m);
  knots.push_back(Real(1e300));
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const auto sign = [&](Real x) {
      if (abs(x) >= Real(1e300)) return (x > 0 ? 1 : -1) * (exact[3] > 0 ? 1 : -1);
      const Real v = value(exact, x);
      if (abs(v) <= Real(kRobust * f.size(double(x)))) return 0;
      return v > 0 ? 1 : -1;
    };
    if (sign(knots[i]) * sign(knots[i + 1]) >= 0) continue;
    const Real root = root_between(exact, slope, knots[i] < -Real(1e299) ? -Real(1e60) : knots[i],
                                   knots[i + 1] > Real(1e299) ? Real(1e60) : knots[i + 1]);
    const double condition = 0x1p-52 * f.size(double(root)) / double(abs(value(slope, root))) +
                             0x1p-52 * double(abs(root));
    bool here = false;
    for (int k = 0; k < found.count; ++k)
      here |= double(abs(found.x[k] - root)) <= CubicContract::kConditionUnits * condition;
    if (!here) ++outcome.missed;
  }
}

Cubic sample(int family, Random& r) {
  switch (family) {
    case 0:
      if (r.chance(0.5))
        return from_roots(1, r.between(-1, 1), r.between(-1, 1), r.between(-1, 1));
      else {  // one real root and a complex pair
        const Real x = r.between(-1, 1), re = r.between(-1, 1), im = r.size(-3, 0);
        const Polynomial f = Polynomial{-x, 1} * Polynomial{re * re + im * im, -2 * re, 1};
        return {1, double(f[2]), double(f[1]), double(f[0])};
      }
    case 1: {  // the foot of a point on a quadratic Bézier curve
      const glm::dvec2 p0 = r.point(0, 1), p1 = r.point(0, 1), p2 = r.point(0, 1),
                       p = r.point(0, 1);
      const glm::dvec2 a = p1 - p0, b = p2 - p1 - a, q = p0 - p;
      const auto dot = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.x + u.y * v.y; };
      return {dot(b, b), 3 * dot(a, b), 2 * dot(a, a) + dot(q, b), dot(q, a)};
    }
    case 2: {
      const Real x = r.between(-1, 1);
      return from_roots(r.between(0.5, 2), x, x + Real(r.size(-12, -3)), r.between(-1, 1));
    }
    case 3: {
      const Real x = r.between(-1, 1);
      const Real gap = r.size(-12, -3);
      return from_roots(r.between(0.5, 2), x, x + gap, x - Real(r.size(-12, -3)));
    }
    case 4:
      return {r.size(-16, -3) * r.sign(), r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)};
    default: {
      const auto any = [&] { return r.size(-20, 20) * r.sign(); };
      const double a = any(), b = any(), c = any();
      return {a, b, c, any()};
    }
  }
}

class CubicFamily : public testing::TestWithParam<int> {};

TEST_P(CubicFamily, IsSolvedToTheConditionOfItsRoots) {
  Random r(11 + GetParam());
  Outcome outcome;
  for (int i = 0; i < times(4'000); ++i) judge(sample(GetParam(), r), outcome);
  EXPECT_EQ(outcome.missed, 0);
  EXPECT_EQ(outcome.invented, 0);
  EXPECT_EQ(outcome.disordered, 0);
  EXPECT_LE(outcome.worst, CubicContract::kConditionUnits);
  RecordProperty("worst_backward_error", std::to_string(outcome.worst));
}
INSTANTIATE_TEST_SUITE_P(AllFamilies, CubicFamily, testing::Range(0, 6));

void expect_roots(const Roots& r, std::initializer_list<double> expected,
                  double tolerance = 1e-15) {
  ASSERT_EQ(r.count, int(expected.size()));
  int i = 0;
  for (const double x : expected) EXPECT_NEAR(r.x[i++], x, tolerance * std::max(1.0, std::abs(x)));
}

TEST(SolveCubic, FixturesThatOtherSolversMissed) {
  expect_roots(solve_cubic(1, -886.7970773009183, 262148.4783430062, -264000817.775054),
               {915.453859}, 1e-9);
  const Roots r =
      solve_cubic(-4.0410628481035e-17, 0.0126298310280606, -0.100896606408756, 0.0689539597036461);
  ASSERT_EQ(r.count, 3);
  EXPECT_NEAR(r.x[0], 0.754710877, 1e-9);
  expect_roots(solve_cubic(1e-20, 1, -3, 2), {-1e20, 1, 2});
}

TEST(SolveCubic, GivesMultipleRootsOnce) {
  expect_roots(solve_cubic(1, 0, -3, 2), {-2, 1});
  expect_roots(solve_cubic(1, -3, 3, -1), {1});
  expect_roots(solve_cubic(1, 0, 0, 0), {0});
  expect_roots(solve_cubic(1, -1, 0, 0), {0, 1});
  const double a = 0.1, b = 0.7;  // coefficients rounded: still one double root
  expect_roots(solve_cubic(1, -(2 * a + b), a * a + 2 * a * b, -a * a * b), {0.1, 0.7}, 1e-7);
}

TEST(SolveCubic, SolvesLowerDegrees) {
  expect_roots(solve_cubic(0, 1, -3, 2), {1, 2});
  expect_roots(solve_cubic(0, 1, 2, 1), {-1});
  expect_roots(solve_cubic(0, 1, 0, 1), {});
  expect_roots(solve_cubic(0, 0, 2, 1), {-0.5});
  expect_roots(solve_cubic(0, 0, 0, 1), {});
  EXPECT_EQ(solve_cubic(0, 0, 0, 0).count, -1);
  EXPECT_EQ(solve_quadratic(0, 0, 0).count, -1);
}

TEST(SolveCubic, MindsOverflowAndUnderflow) {
  for (const double k : {1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300})
    expect_roots(solve_cubic(k, -6 * k, 11 * k, -6 * k), {1, 2, 3}, 1e-14);
  expect_roots(solve_cubic(1e-300, 0, 0, -1e300), {1e200}, 1e-14);
  expect_roots(solve_cubic(1e300, 0, 0, -1e-300), {1e-200}, 1e-14);
  expect_roots(solve_quadratic(1, 0, -1e-320), {-1e-160, 1e-160}, 1e-6);
  expect_roots(solve_quadratic(1e-300, 0, -1e300), {-1e300, 1e300}, 1e-14);
}

TEST(SolveCubic, AnswersNonsenseWithNoRoots) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {inf, -inf, nan}) {
    EXPECT_EQ(solve_cubic(bad, 1, 1, 1).count, 0);
    EXPECT_EQ(solve_cubic(1, bad, 1, 1).count, 0);
    EXPECT_EQ(solve_cubic(1, 1, bad, 1).count, 0);
    EXPECT_EQ(solve_cubic(1, 1, 1, bad).count, 0);
    EXPECT_EQ(solve_quadratic(1, bad, 1).count, 0);
  }
}

TEST(SolveCubic, MirroredCoefficientsGiveMirroredRoots) {
  Random r(5);
  for (int i = 0; i < times(2000); ++i) {
    Cubic f = sample(i % 6, r);
    if (i % 7 == 0) f.b = 0;
    if (i % 11 == 0) f.a = f.c = 0;
    const Roots x = solve_cubic(f.a, f.b, f.c, f.d), y = solve_cubic(-f.a, f.b, -f.c, f.d);
    ASSERT_EQ(x.count, y.count);
    for (int k = 0; k < x.count; ++k) EXPECT_EQ(x.x[k], -y.x[y.count - 1 - k]);
  }
}

}  // namespace
}  // namespace mien::test
