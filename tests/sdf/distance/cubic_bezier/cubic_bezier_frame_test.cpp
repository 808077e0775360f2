#include "sdf/distance/cubic_bezier/cubic_bezier_frame.h"

#include <gtest/gtest.h>

#include "tools/accuracy/families.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace mien::batch {
namespace {

const CubicBezier kCurve{{0.3, 0.1}, {0.9, 0.4}, {0.2, 1.1}, {0.7, 0.2}};

std::vector<CubicBezier> curves() {
  std::vector<CubicBezier> all{kCurve,
                               {{0, 0}, {1, 1}, {0, 1}, {1, 0}},
                               {{0, 0}, {1, 0}, {-1, 0}, {0.5, 0}},
                               {{0, 0}, {0, 0}, {1, 1}, {1, 1}}};
  accuracy::Random r(4);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec2 p0 = r.point(), p1 = r.point(), p2 = r.point();
    all.push_back({p0, p1, p2, r.point()});
  }
  return all;
}

/// f = (B − p)·B'/3 and its first two derivatives, scaled, from the control points.
struct Slope {
  double f, f1, f2;
};
Slope slope_at(const CubicBezier& c, double scale, glm::dvec2 p, double t) {
  const glm::dvec2 u0 = (c.p1 - c.p0) * scale, u1 = (c.p2 - c.p1) * scale;
  const glm::dvec2 u2 = (c.p3 - c.p2) * scale;
  const glm::dvec2 q = (point(c, t) - p) * scale, u = tangent(c, t) * scale / 3.0;
  const glm::dvec2 v = 2.0 * ((1 - t) * (u1 - u0) + t * (u2 - u1)), w = 2.0 * (u2 - 2.0 * u1 + u0);
  return {glm::dot(q, u), 3 * glm::dot(u, u) + glm::dot(q, v), 9 * glm::dot(u, v) + glm::dot(q, w)};
}

TEST(CubicFrame, ExpansionAndSamplesAreTheCurve) {
  for (const CubicBezier& c : curves()) {
    const auto f = *cubic_frame<double>(c);
    for (int i = 0; i <= 2 * f.kPieces; ++i) {
      const double t = double(i) / (2 * f.kPieces), r = t - 0.5;
      const glm::dvec2 at = (point(c, t) - c.p0) * f.scale, u = tangent(c, t) * f.scale / 3.0;
      const auto& k = f.fine;
      EXPECT_NEAR(f.sample[i].x, at.x, 1e-14);
      EXPECT_NEAR(f.sample[i].y, at.y, 1e-14);
      EXPECT_NEAR(f.sample[i].ux, u.x, 1e-14);
      EXPECT_NEAR(f.sample[i].uy, u.y, 1e-14);
      EXPECT_NEAR(k.mx + r * (k.ax + r * (k.bx + r * k.cx)), at.x, 1e-14);
      EXPECT_NEAR(k.my + r * (k.ay + r * (k.by + r * k.cy)), at.y, 1e-14);
      EXPECT_NEAR(k.ux + r * (k.vx + r * k.cx), u.x, 1e-14);
      const glm::dvec2 first = c.p2 - 2.0 * c.p1 + c.p0, last = c.p3 - 2.0 * c.p2 + c.p1;
      const glm::dvec2 v = 2.0 * f.scale * ((1 - t) * first + t * last);
      EXPECT_NEAR(k.vx + r * k.c2x, v.x, 1e-14);
      EXPECT_NEAR(k.vy + r * k.c2y, v.y, 1e-14);
    }
    EXPECT_NEAR(f.fine.end_x, (c.p3.x - c.p0.x) * f.scale, 1e-15);
    EXPECT_NEAR(f.fine.end_y, (c.p3.y - c.p0.y) * f.scale, 1e-15);
  }
}

/// What the proof stands on, at 64 points of every piece, seen from near and far.
TEST(CubicFrame, ItsBoundsHold) {
  constexpr int kPieces = CubicFrame<float>::kPieces;
  constexpr double h = 1.0 / kPieces, kRounding = 1e-5;
  for (const CubicBezier& c : curves()) {
    const auto f = *cubic_frame<float>(c);
    for (const glm::dvec2 p : {glm::dvec2{0.5, 0.5}, {0.31, 0.12}, {-3, 7}}) {
      const auto slope = [&](double t) { return slope_at(c, f.scale, p, t); };
      const auto away = [&](double t) { return f.scale * glm::distance(point(c, t), p); };
      double nearest = 1e30;
      for (int i = 0; i <= 2 * kPieces; ++i) nearest = std::min(nearest, away(i * h / 2));
      for (int i = 0; i < kPieces; ++i) {
        const auto& piece = f.piece[i];
        const double begin = i * h;
        const double f0 = slope(begin).f, fm = slope(begin + h / 2).f, f1 = slope(begin + h).f;
        const double a = fm - f0, b = f1 - fm, size = 1 + nearest;
        double least = 1e30;
        for (const double s : {0.0, 0.5, 1.0}) least = std::min(least, away(begin + s * h));
        for (int k = 0; k <= 64; ++k) {
          const double s = k / 64.0, t = begin + s * h;
          const double parabola = f0 + s * (3 * a - b) + 2 * s * s * (b - a);
          EXPECT_LE(std::abs(slope(t).f - parabola), piece.off + kRounding * h * size);
          const double line = (3 * a - b) + 4 * s * (b - a);
          const double turn = piece.turn * (1 - 6 * s * (1 - s));
          EXPECT_LE(std::abs(h * slope(t).f1 - line - turn), piece.tilt + kRounding * h * size);
          EXPECT_GE(away(t), least - piece.reach / 2);
          if (least <= nearest + piece.reach / 2) {
            for (const double beyond : {-1.0 / 64, 0.0, 1.0 / 64}) {
              const double most = f.curl + nearest * f.curl_far;
              EXPECT_LE(std::abs(slope(t + beyond).f2), most * (1 + kRounding));
            }
          }
        }
        EXPECT_GE(piece.reach2, 0.25 * piece.reach * piece.reach);
      }
    }
  }
}

TEST(CubicFrame, ScaleBringsTheLargestLegBetweenAHalfAndOne) {
  for (const double size : {1e-30, 1e-3, 1.0, 7.0, 1e20}) {
    const CubicBezier c{kCurve.p0 * size, kCurve.p1 * size, kCurve.p2 * size, kCurve.p3 * size};
    const auto f = *cubic_frame<float>(c);
    const double leg = size * 0.9 * double(f.scale);  // p3.y − p2.y
    EXPECT_GE(leg, 0.5) << size;
    EXPECT_LT(leg, 1.0) << size;
    EXPECT_EQ(f.scale * f.unscale, 1);
  }
}

TEST(CubicFrame, PointsAndNonsenseHaveNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(cubic_frame<float>({{1, 2}, {1, 2}, {1, 2}, {1, 3}}));
  EXPECT_FALSE(cubic_frame<float>({{1, 2}, {1, 2}, {1, 2}, {1, 2}}));
  EXPECT_FALSE(cubic_frame<double>({{nan, 2}, {1, 2}, {1, 3}, {0, 0}}));
  EXPECT_FALSE(cubic_frame<double>({{0, 2}, {1, 2}, {1, 3}, {0, nan}}));
  EXPECT_FALSE(cubic_frame<double>({{0, 2}, {1e200, 2}, {1, 3}, {0, 0}}));
}

}  // namespace
}  // namespace mien::batch
