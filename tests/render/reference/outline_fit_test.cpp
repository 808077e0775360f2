#include <mien/shape.h>
#include "render/reference/outline_fit_private.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

template <class Distance>
NineDistances nine(double half, Distance distance) {
  NineDistances d;
  for (int i = 0; i < 9; ++i)
    d[std::size_t(i)] = distance(glm::dvec2{half * (i % 3 - 1), half * (i / 3 - 1)});
  return d;
}

TEST(OutlineFit, OfAHalfPlaneIsExact) {
  Random r(1);
  for (int i = 0; i < 200; ++i) {
    const HalfPlane plane{r.direction(), r.between(-1, 1)};
    const OutlineFit fit =
        fit_outline(nine(0.3, [&](glm::dvec2 p) { return distance(plane, p); }), 0.3);
    EXPECT_NEAR(fit.at, -plane.offset, 1e-13);
    EXPECT_NEAR(glm::distance(fit.normal, plane.normal), 0.0, 1e-13);
    EXPECT_NEAR(fit.bend, 0.0, 1e-11);
    EXPECT_LT(fit.off, 1e-13);
  }
}

TEST(OutlineFit, OfADiscKnowsItsBend) {
  Random r(2);
  for (int i = 0; i < 200; ++i) {
    const double radius = r.between(2, 20), h = 0.05;
    const glm::dvec2 out = r.direction();
    const Disc disc{-radius * out, radius};
    const OutlineFit fit = fit_outline(nine(h, [&](glm::dvec2 p) { return distance(disc, p); }), h);
    EXPECT_NEAR(fit.at, 0.0, h * h * h / radius);
    EXPECT_NEAR(fit.bend, 1.0 / radius, 2.0 * h / (radius * radius));
    EXPECT_NEAR(glm::distance(fit.normal, out), 0.0, 2.0 * h * h / (radius * radius));
    EXPECT_LT(fit.off, h * h * h / (radius * radius));
  }
}

TEST(OutlineFit, KinksAreSeen) {
  const double h = 0.1;
  const auto off = [&](auto distance) { return fit_outline(nine(h, distance), h).off; };
  EXPECT_GT(off([](glm::dvec2 p) { return std::abs(p.x); }), 0.02);
  EXPECT_GT(off([](glm::dvec2 p) { return std::max(p.x, p.y); }), 0.01);
  EXPECT_GT(off([](glm::dvec2 p) { return glm::length(p); }), 0.02);
  EXPECT_GT(off([](glm::dvec2 p) { return std::min(p.x, 0.09 - p.x); }), 0.01);
  EXPECT_GT(off([](glm::dvec2) { return 0.0; }), 1.0);
  EXPECT_GT(off([](glm::dvec2) { return HUGE_VAL; }), 1.0);
}

/// A cubic may be off by as much as the bend of a bend, but never by more than a fiftieth of the square.
TEST(OutlineFit, MayBeOffByItsBendAlone) {
  OutlineFit fit{};
  fit.bend = 0.5;
  EXPECT_DOUBLE_EQ(allowed_off(fit, 0.1, 1e-4), 1e-4 + 2 * 0.25 * 0.01 * 0.1);
  fit.bend = 50;
  EXPECT_DOUBLE_EQ(allowed_off(fit, 0.1, 1e-4), 1e-4 + 0.02 * 0.1);
}

TEST(ChordInSquare, IsWhatTheSquareHolds) {
  const Chord level = chord_in_square({0, 1}, -0.2, 0.5);
  EXPECT_NEAR(level.length(), 1.0, 1e-15);
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(chord_in_square({s, s}, 0.0, 0.5).length(), std::sqrt(2.0), 1e-15);
  EXPECT_EQ(chord_in_square({0, 1}, -0.6, 0.5).length(), 0.0);
  EXPECT_EQ(chord_in_square({s, s}, -0.8, 0.5).length(), 0.0);
  EXPECT_NEAR(chord_in_square({s, s}, -0.5, 0.5).length(), std::sqrt(2.0) - 1.0, 1e-15);
}

}  // namespace
}  // namespace mien::test
