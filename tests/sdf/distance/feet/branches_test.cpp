#include "sdf/distance/feet/branches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/random/random.h"

namespace mien {
namespace {

Spine random_spine(test::Random& random, double wide) {
  const glm::dvec2 a = random.point(-30, 30), b = random.point(-30, 30), c = random.point(-30, 30);
  const glm::dvec2 first = 2.0 * (b - a), second = a - 2.0 * b + c;
  return {a.x, first.x, second.x, a.y, first.y, second.y, wide, random.between(-wide, wide),
          0.0, 0,       0,        0,   0,       0};
}

double key(const Spine& s, double t, glm::dvec2 p) {
  return glm::distance(on_spine(s, t), p) - width_on_spine(s, t);
}

/// The least over a branch's whole stretch, seen from a place of the disc.
double least_on(const Branches& b, int k, glm::dvec2 p) {
  const auto at = [&](Branches::Row r) { return double(b.row(r)[k]); };
  double least = 1e9;
  for (int i = 0; i <= 4000; ++i) {
    const double t = at(Branches::low) + (at(Branches::high) - at(Branches::low)) * i / 4000;
    const double x = at(Branches::x0) + t * (at(Branches::x1) + t * at(Branches::x2)) - p.x;
    const double y = at(Branches::y0) + t * (at(Branches::y1) + t * at(Branches::y2)) - p.y;
    const double w = at(Branches::w0) + t * (at(Branches::w1) + t * at(Branches::w2));
    least = std::min(least, std::hypot(x, y) - w);
  }
  return least;
}

TEST(Branches, HoldWhateverIsNearestInTheirDisc) {
  test::Random random(9);
  int seen = 0;
  for (int k = 0; k < 200; ++k) {
    SpineList outline{.stroke = true};
    for (int i = 0; i < 1 + k % 6; ++i)
      outline.spines.push_back(random_spine(random, k % 3 ? 0.0 : random.between(1, 6)));
    const glm::dvec2 middle = random.point(-20, 20);
    const double radius = random.between(1, 12);
    Branches b;
    gather_branches(outline, middle, radius, b);
    if (b.crowded) continue;
    ++seen;
    for (int i = 0; i < 5; ++i) {
      const glm::dvec2 off = random.between(0, radius) * random.direction();
      double want = 1e9, got = 1e9;
      for (const Spine& s : outline.spines)
        for (int q = 0; q <= 4000; ++q) want = std::min(want, key(s, q / 4000.0, middle + off));
      for (int q = 0; q < b.count; ++q) got = std::min(got, least_on(b, q, off));
      EXPECT_NEAR(got, want, 2e-2) << k;
    }
  }
  EXPECT_GT(seen, 150);
}

TEST(Branches, OfLongSpinesAreAsExactAsOfShortOnes) {
  const SpineList line{.spines = {{-4e6, 8e6, 0, 3, 0, 0, 0, 0, 0, 0, -1, 0, -1, 1}}};
  Branches b;
  gather_branches(line, {1234.5, 0}, 12, b);
  ASSERT_FALSE(b.crowded);
  ASSERT_GT(b.count, 0);
  for (int k = 0; k < b.count; ++k) EXPECT_LT(std::abs(b.row(Branches::x1)[k]), 2000.0f);
}

TEST(Branches, OfTooManySpinesAreCrowded) {
  test::Random random(10);
  SpineList outline{.stroke = true};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 p = random.point(-1, 1);
    outline.spines.push_back({p.x, 0, 0, p.y, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  }
  Branches b;
  gather_branches(outline, {0, 0}, 12, b);
  EXPECT_TRUE(b.crowded);
}

}  // namespace
}  // namespace mien
