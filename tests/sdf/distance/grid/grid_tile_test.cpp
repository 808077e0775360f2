// What a certified tile promises, checked at many of its points against the scalar form.

#include "sdf/distance/grid/grid_tile.h"
#include <mien/quad_bezier_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>

namespace mien::batch {
namespace {

using How = GridTile::How;

struct Newton {
  const QuadBezier& c;
  glm::dvec2 p;
  double by_series(double t, double inverse) const {
    const glm::dvec2 q = point(c, t) - p, g = tangent(c, t);
    const double e = 1 - inverse * (glm::dot(g, g) + glm::dot(q, bend(c)));
    return t - glm::dot(q, g) * inverse * (1 + e + e * e);
  }
  double after(double t, int steps) const {
    for (int i = 0; i < steps; ++i) {
      const glm::dvec2 q = point(c, t) - p, g = tangent(c, t);
      t -= glm::dot(q, g) / (glm::dot(g, g) + glm::dot(q, bend(c)));
      t = std::clamp(t, 0.0, 1.0);
    }
    return t;
  }
};

TEST(GridTile, WhatIsCertifiedIsTrueAtEveryPoint) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  std::map<How, int> tally;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto any = [&] { return glm::dvec2{unit(random), unit(random)}; };
    QuadBezier c{any(), any(), any()};
    if (trial % 5 == 0) c.p1 = 0.5 * (c.p0 + c.p2) + std::pow(10, -6 * unit(random)) * any();
    const int exponent = *scale_exponent(c);
    const double k = std::ldexp(1.0, exponent);
    const auto frame = quad_bezier_frame<double>(c, exponent);
    const QuadBezier scaled{k * c.p0, k * c.p1, k * c.p2};
    TileCertifier certifier(frame);
    const glm::dvec2 middle = k * (2.0 * any() - 0.5);
    const double reach = std::pow(10, -3 + 2.5 * unit(random));
    const GridTile tile = certifier.certify(middle, reach);
    ++tally[tile.how];
    if (tile.how == How::uncertain) continue;
    for (int i = 0; i < 30; ++i) {
      glm::dvec2 e{both(random), both(random)};
      e *= (i % 3 == 0 ? 1.0 : unit(random)) * reach / std::max(glm::length(e), 1e-9);
      if (glm::length(e) > reach) e *= 1 - 1e-12;
      const glm::dvec2 p = middle + e;
      double t = tile.t;
      if (tile.how != How::end) {
        const double w = tile.wx * e.x + tile.wy * e.y, z = tile.zx * e.x + tile.zy * e.y;
        const Newton newton{scaled, p};
        t += w + w * z;
        t = tile.how == How::multiplied ? newton.by_series(t, tile.inverse)
                                        : newton.after(t, tile.how == How::one_step ? 1 : 2);
      }
      const double found = glm::distance(point(scaled, t), p), truth = distance(scaled, p);
      ASSERT_LE(found - truth, TileCertifier::kTolerance)
          << trial << ' ' << i << " how " << int(tile.how) << " reach " << reach;
    }
  }
  EXPECT_GT(tally[How::multiplied], 300);
  EXPECT_GT(tally[How::one_step], 100);
  EXPECT_GT(tally[How::two_steps], 100);
  EXPECT_GT(tally[How::end], 30);
  EXPECT_GT(tally[How::uncertain], 100);
}

TEST(GridTile, NothingIsCertifiedAcrossTheAxisOrAtTheCuspOfTheEvolute) {
  const QuadBezier c{{-1, 1}, {0, -1}, {1, 1}};  // y = x², focus at 1/4, cusp at 1/2
  const auto frame = quad_bezier_frame<double>(c, 0);
  TileCertifier certifier(frame);
  EXPECT_EQ(certifier.certify({0, 0.5}, 0.01).how, How::uncertain);
  EXPECT_EQ(certifier.certify({0.001, 0.9}, 0.01).how, How::uncertain);
  EXPECT_NE(certifier.certify({0.3, 0.9}, 0.01).how, How::uncertain);
  EXPECT_NE(certifier.certify({0, 0.1}, 0.01).how, How::uncertain);
  EXPECT_EQ(certifier.certify({NAN, 0.1}, 0.01).how, How::uncertain);
}

/// Where a tile's predecessor was only changes where Newton begins.
TEST(GridTile, ComesToTheSameFootFromAnywhere) {
  const QuadBezier c{{-1, 1}, {0, -1}, {1, 1}};
  const auto frame = quad_bezier_frame<double>(c, 0);
  TileCertifier warm(frame);
  for (const glm::dvec2 before : {glm::dvec2{-0.9, 0.9}, {0.9, 0.9}, {0.2, 0.1}}) {
    warm.certify(before, 0.01);
    TileCertifier cold(frame);
    const GridTile a = warm.certify({0.35, 0.9}, 0.01), b = cold.certify({0.35, 0.9}, 0.01);
    EXPECT_NEAR(a.t, b.t, 1e-9);
    EXPECT_EQ(a.how, b.how);
  }
}

}  // namespace
}  // namespace mien::batch
