#include <mien/ellipse_distance.h>

#include "tests/support/exact/real128.h"
#include "tests/support/process/effort.h"
#include "tests/support/shapes/shape_examples/ellipse.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

/// Unsigned distance from (x, y) >= 0 to the ellipse with radii a >= b > 0: every real root of the
/// quartic (a x)² T² + (b y)² (T + c)² = T² (T + c)², c = a² − b², T >= 0.
Real exact_distance(Real a, Real b, Real x, Real y) {
  const Real c = a * a - b * b;
  if (c == 0) return abs(length(Real2{x, y}) - a);
  if (y == 0) {
    Real best = abs(x - a);
    if (a * x < c) {
      const Real k = a * x / c;
      best = length(Real2{x - a * k, b * sqrt((1 - k) * (1 + k))});
    }
    return best;
  }
  // The secular function falls from +inf to −1 on T > 0: halve its sign change, in the exponent,
  // then in the value.
  const auto g = [&](Real t) {
    const Real u = a * x / (t + c), v = b * y / t;
    return u * u + v * v - 1;
  };
  Real lo = b * y / 2, hi = 2 * length(Real2{a * x, b * y});
  for (int i = 0; i < 400; ++i) {
    const Real t = hi > 4 * lo ? sqrt(lo) * sqrt(hi) : (lo + hi) / 2;
    if (!(t > lo && t < hi)) break;
    (g(t) > 0 ? lo : hi) = t;
  }
  return length(Real2{x - a * a * x / (lo + c), y - b * b * y / lo});
}

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(Ellipse, ShapeLaws, Ellipse);

TEST(Ellipse, IsExactForEveryRatio) {
  Random r(1);
  WorstError worst;
  for (int i = 0; i < times(30'000); ++i) {
    const double b = i % 3 == 0 ? 1 - r.size(-16, -0.1) : r.size(i % 3 == 1 ? -3 : -12, 0);
    const double angle = r.between(0, 1.5707963), c = (1 - b) * (1 + b);
    glm::dvec2 p = 2.0 * r.point(0, 1);
    switch (r.below(7)) {
      case 0:
        p = {std::cos(angle), b * std::sin(angle)};
        break;
      case 1:
        p = glm::dvec2(std::cos(angle), b * std::sin(angle)) * (1 + r.sign() * r.size(-16, -1));
        break;
      case 2:
        p = {c * std::pow(std::cos(angle), 3), c / b * std::pow(std::sin(angle), 3)};
        break;  // evolute
      case 3:
        p = {c * (1 + r.sign() * r.size(-16, -1)), r.size(-30, -1)};
        break;  // its cusp
      case 4:
        p.y = r.chance(0.3) ? 0 : r.size(-300, -1);
        break;
      case 5:
        p.x = r.chance(0.3) ? 0 : r.size(-300, -1);
        break;
      default:
        break;
    }
    const bool tall = r.chance(0.5);
    const Ellipse e{{0, 0}, tall ? glm::dvec2(b, 1) : glm::dvec2(1, b)};
    const glm::dvec2 q = (tall ? glm::dvec2(p.y, p.x) : p) * glm::dvec2(r.sign(), r.sign());
    const double d = distance(e, q);
    const Real exact = exact_distance(1, b, p.x, p.y);
    worst.note(q, d, double(exact - Real(std::abs(d))), norm(p) + 1);
  }
  EXPECT_LE(worst.units, EllipseContract::kError / 0x1p-52) << worst;
  RecordProperty("worst", std::to_string(worst.units));
}

TEST(Ellipse, KnownDistances) {
  const Ellipse e{{0, 0}, {5, 3}, {1, 0}};
  EXPECT_EQ(distance(e, {0, 0}), -3);
  EXPECT_EQ(distance(e, {0, 7}), 4);
  EXPECT_EQ(distance(e, {-7, 0}), 2);
  EXPECT_EQ(distance(e, {5, 0}), 0);
  EXPECT_EQ(distance(Ellipse{{1, 1}, {2, 2}}, {1, 1}), -2);
  EXPECT_EQ(distance(Ellipse{{1, 1}, {0, 0}}, {4, 5}), 5);
  EXPECT_EQ(distance(Ellipse{{0, 0}, {1, 1e-200}}, {0.5, 2}), 2);
  EXPECT_EQ(distance(Ellipse{{0, 0}, {1e200, 5e199}}, {0, 1e200}), 5e199);
  EXPECT_EQ(distance(Ellipse{{0, 0}, {1e-300, 5e-301}}, {0, 1e-300}), 5e-301);
}

TEST(Ellipse, NearestPointIsOnTheOutlineAtTheDistance) {
  Random r(2);
  for (int i = 0; i < times(5000); ++i) {
    const Ellipse e{r.point(-1, 1), {r.size(-2, 0), r.size(-2, 0)}, r.direction()};
    const glm::dvec2 p = r.point(-2, 2);
    const NearestOnEllipse n = nearest(e, p);
    EXPECT_NEAR(norm(n.point - p), std::abs(n.distance), 1e-14);
    EXPECT_NEAR(inside_of(e, n.point), 0, 1e-12 / std::min(e.radii.x, e.radii.y));
  }
}

}  // namespace mien::test
