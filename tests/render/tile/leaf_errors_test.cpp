// The bounds against the areas they bound, by numerical integration.

#include <mien/render/tile/leaf_errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace mien {
namespace {

/// Longest way through a square of side 1 from its middle, along an edge.
constexpr double kHalfDiagonal = 0.70710678118654757;

double integral(double from, double to, const std::function<double(double)>& f) {
  constexpr int kSteps = 4000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) sum += f(from + (to - from) * (i + 0.5) / kSteps);
  return sum * (to - from) / kSteps;
}

TEST(LeafErrors, ACircleLeavesItsParabolaByNoMore) {
  for (const double side : {1.0, 0.25, 0.0625})
    for (const double bend : {0.05, 0.1, 0.2}) {  // beyond, squares of a pixel are divided
      const double reach = kHalfDiagonal * side, radius = 1.0 / bend;
      const double area = integral(-reach, reach, [&](double t) {
        return std::abs(radius - std::sqrt(radius * radius - t * t) - 0.5 * bend * t * t);
      });
      const double squares = 2.0 / side;
      EXPECT_GE(parabola_error(bend, side), area * squares) << bend << ' ' << side;
      EXPECT_LE(parabola_error(bend, side), area * squares * 1.1) << bend << ' ' << side;
    }
}

TEST(LeafErrors, AnEndTakenForItsBodyCoversNoMore) {
  for (const double side : {1.0, 0.25})
    for (const double bend : {0.2, 0.8}) {
      const double area =
          integral(0.0, kHalfDiagonal * side, [&](double x) { return 0.5 * bend * x * x; });
      EXPECT_GE(end_error(bend, side), area);
      EXPECT_LE(end_error(bend, side), 1.1 * area);
    }
}

TEST(LeafErrors, AJointTakenForOneBodyCoversNoMore) {
  for (const double side : {1.0, 0.25})
    for (const double bend : {-0.5, 0.0, 0.2}) {
      const double area = integral(0.0, kHalfDiagonal * side, [&](double x) {
        return 0.5 * std::abs(bend) * x * x + kMostJointTurn * x;
      });
      EXPECT_GE(joint_error(bend, side), area);
      EXPECT_LE(joint_error(bend, side), 1.1 * area);
    }
}

TEST(LeafErrors, AStraightenedEdgeInCompanyIsOffByNoMore) {
  for (const double side : {1.0, 0.25})
    for (const double bend : {0.05, 0.4}) {
      const double length = 2.0 * kHalfDiagonal * side, mean = bend * length * length / 24.0;
      const double area = integral(-0.5 * length, 0.5 * length, [&](double t) {
        return std::max(0.0, 0.5 * bend * t * t - mean);
      });
      // One square's, and as much again: the edges may cross near a border.
      EXPECT_GE(together_error(bend, side), 2.0 * area);
    }
}

}  // namespace
}  // namespace mien
