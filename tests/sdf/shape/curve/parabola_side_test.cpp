#include <mien/parabola_side.h>

#include "tests/support/exact/real128.h"
#include "tests/support/process/effort.h"
#include "tests/support/shapes/shape_examples/parabola_side.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

struct Exact {
  Real distance, size;  ///< size: |p − foot| + the coordinates of both
};

/// Axis (0, 1), vertex 0: every root of the cubic.
Exact exact(double bend, glm::dvec2 p) {
  const Real k = bend, u = p.x, v = p.y;
  Real best = -1, size = 0;
  std::vector<Real> feet = real_roots({-u, 1 - 2 * k * v, Real(0), 2 * k * k});
  for (const Real s : feet) {
    const Real2 off{s - u, k * s * s - v};
    const Real d = length(off);
    if (best < 0 || d < best) {
      best = d;
      size = d + abs(s) + abs(k * s * s) + abs(u) + abs(v);
    }
  }
  return {v > k * u * u ? -best : best, size};
}

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(ParabolaSide, ShapeLaws, ParabolaSide);

TEST(ParabolaSide, IsExactForEveryBend) {
  Random r(1);
  WorstError worst;
  for (int i = 0; i < times(20'000); ++i) {
    const double bend = (i % 5 == 0 ? 1.0 : r.size(-12, 12)) * r.sign();
    glm::dvec2 p = r.size(-3, 3) * r.point(-1, 1);
    switch (i % 6) {
      case 0:
        p.y = bend * p.x * p.x;
        break;  // on it
      case 1:
        p.y = bend * p.x * p.x * (1 + r.sign() * r.size(-16, -1));
        break;  // near it
      case 2:
        p = {r.size(-16, -2) * r.sign(), 0.5 / bend * (1 + r.sign() * r.size(-16, -1))};
        break;   // cusp
      case 3: {  // the evolute: u = −4k²s³, v = 1/(2k) + 3ks²
        const double s = r.size(-3, 2) * r.sign() / std::abs(bend);
        p = {-4 * bend * bend * s * s * s, 0.5 / bend + 3 * bend * s * s};
        break;
      }
      case 4:
        p.x = 0;
        break;
      default:
        break;
    }
    if (!(norm(p) < 1e60)) continue;
    const double d = distance(ParabolaSide{{0, 0}, {0, 1}, bend}, p);
    const Exact e = exact(bend, p);
    worst.note(p, d, double(e.distance - Real(d)), double(e.size));
  }
  EXPECT_LE(worst.units, ParabolaSideContract::kError / 0x1p-52) << worst;
  RecordProperty("worst", std::to_string(worst.units));
}

TEST(ParabolaSide, KnownDistances) {
  const ParabolaSide cup{{0, 0}, {0, 1}, 1};
  EXPECT_EQ(distance(cup, {0, -2}), 2);
  EXPECT_EQ(distance(cup, {0, 0}), 0);
  EXPECT_EQ(distance(cup, {0, 0.25}), -0.25);
  EXPECT_DOUBLE_EQ(distance(cup, {0, 2}), -std::sqrt(1.75));
  EXPECT_EQ(distance(ParabolaSide{{0, 0}, {0, 1}, 0}, {7, 2}), -2);
  EXPECT_EQ(distance(ParabolaSide{{0, 0}, {0, 1}, 1e-320}, {7, 2}), -2);
  EXPECT_NEAR(distance(ParabolaSide{{0, 0}, {0, 1}, 1e300}, {3, 2}), 3, 1e-12);
  EXPECT_NEAR(distance(ParabolaSide{{0, 0}, {0, 1}, 1e300}, {3, -4}), 5, 1e-12);
  EXPECT_DOUBLE_EQ(distance(ParabolaSide{{0, 0}, {0, 1}, -1}, {0, -2}), std::sqrt(1.75));
}

TEST(ParabolaSide, NearestPointIsOnTheOutlineAtTheDistance) {
  Random r(2);
  for (int i = 0; i < times(5000); ++i) {
    const ParabolaSide s{r.point(-1, 1), r.direction(), r.size(-3, 3) * r.sign()};
    const glm::dvec2 p = r.point(-3, 3);
    const NearestOnParabola n = nearest(s, p);
    EXPECT_EQ(n.distance, distance(s, p));
    EXPECT_NEAR(norm(n.point - p), std::abs(n.distance), 1e-12);
    EXPECT_NEAR(inside_of(s, n.point), 0, 1e-11 * (1 + std::abs(s.bend)));
    bool among = false;
    const Roots all = feet(s, p);
    for (int k = 0; k < all.count; ++k) {
      among |= norm(point(s, all.x[k]) - n.point) < 1e-6;
      EXPECT_GE(norm(point(s, all.x[k]) - p), std::abs(n.distance) - 1e-12);
    }
    EXPECT_TRUE(among);
  }
}

}  // namespace mien::test
