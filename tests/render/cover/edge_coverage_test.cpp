#include <mien/render/cover/edge_coverage.h>

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/support/effort.h"

namespace mien {
namespace {

constexpr double kTau = 2 * std::numbers::pi;

/// The oracle: the area of the unit square under d + n·u + bend/2 (along·u)² <= 0, by exact
/// crossings on fine rows.
double sampled_area(double d, double theta, double bend, int rows) {
  const double nx = std::cos(theta), ny = std::sin(theta);
  double area = 0;
  for (int j = 0; j < rows; ++j) {
    const double y = (j + 0.5) / rows - 0.5;
    for (int i = 0; i < rows; ++i) {
      const double x = (i + 0.5) / rows - 0.5;
      const double s = d + nx * x + ny * y, along = -ny * x + nx * y;
      area += s + 0.5 * bend * along * along < 0;
    }
  }
  return area / (double(rows) * rows);
}

TEST(StraightEdgeCoverage, EqualsSupersampling) {
  for (double theta = 0; theta < kTau; theta += 0.13)
    for (double d = -0.9; d <= 0.9; d += 0.07)
      EXPECT_NEAR(straight_edge_coverage(d, {std::cos(theta), std::sin(theta)}),
                  sampled_area(d, theta, 0, 512), 3e-3)
          << "d " << d << " theta " << theta;
}

TEST(StraightEdgeCoverage, IsComplementaryMonotoneAndFullBeyondTheSquare) {
  for (double theta = 0; theta < kTau; theta += 0.1) {
    const glm::dvec2 n{std::cos(theta), std::sin(theta)};
    double last = 1;
    for (double d = -1; d <= 1; d += 0.01) {
      const double area = straight_edge_coverage(d, n);
      EXPECT_NEAR(area + straight_edge_coverage(-d, n), 1, EdgeCoverageContract::kStraightError);
      EXPECT_LE(area, last + EdgeCoverageContract::kStraightError);
      last = area;
    }
    EXPECT_EQ(straight_edge_coverage(-0.7072, n), 1);
    EXPECT_EQ(straight_edge_coverage(0.7072, n), 0);
  }
}

TEST(StraightEdgeCoverage, NotANumberIsOutside) {
  EXPECT_EQ(straight_edge_coverage(std::numeric_limits<double>::quiet_NaN(), {1, 0}), 0);
}

/// Exact by quadrature: for each x along the tangent direction a row of the square is cut where the
/// parabola is.
double bent_area(double d, double theta, double bend) {
  // Integrate over columns x: inside is an interval set in y found by solving the quadratic in y.
  const double nx = std::cos(theta), ny = std::sin(theta);
  const int columns = 4000;
  double area = 0;
  for (int i = 0; i < columns; ++i) {
    const double x = (i + 0.5) / columns - 0.5;
    // s = d + nx x + ny y + bend/2 (−ny x + nx y)²
    const double a = 0.5 * bend * nx * nx, b = ny - bend * ny * nx * x;
    const double c = d + nx * x + 0.5 * bend * ny * ny * x * x;
    const auto length = [](double lo, double hi) {
      return std::max(0.0, std::min(hi, 0.5) - std::max(lo, -0.5));
    };
    if (std::abs(a) < 1e-12) {
      area += b == 0 ? c < 0 : b > 0 ? length(-1, -c / b) : length(-c / b, 1);
      continue;
    }
    const double disc = b * b - 4 * a * c;
    if (disc <= 0) {
      area += a < 0;
      continue;
    }
    const double q = -0.5 * (b + std::copysign(std::sqrt(disc), b));
    double r0 = q / a, r1 = c / q;
    if (r0 > r1) std::swap(r0, r1);
    area += a > 0 ? length(r0, r1) : length(-1e9, r0) + length(r1, 1e9);
  }
  return area / columns;
}

TEST(BentEdgeCoverage, EqualsQuadrature) {
  for (const double bend : {0.01, -0.03, 0.1, -0.1, 0.5, -1.0, 1.0})
    for (double theta = 0; theta < kTau; theta += 0.05 * test::kThinning)
      for (double d = -0.75; d <= 0.75; d += 0.025)
        ASSERT_NEAR(bent_edge_coverage(d, {std::cos(theta), std::sin(theta)}, bend),
                    bent_area(d, theta, bend), 4e-5)
            << "bend " << bend << " theta " << theta << " d " << d;  // the oracle's own error
}

TEST(BentEdgeCoverage, HasTheClosedFormsOfAxisParallelEdges) {
  const double tiny = EdgeCoverageContract::kBentError;
  for (const double bend : {0.01, -0.1, 0.7}) {
    EXPECT_NEAR(bent_edge_coverage(0.0, {0, 1}, bend), 0.5 - bend / 24, tiny);
    EXPECT_NEAR(bent_edge_coverage(0.1, {1, 0}, bend), 0.4 - bend / 24, tiny);
  }
  // A tangent on the square's side: the outline bends in over its whole length, or not at all.
  EXPECT_NEAR(bent_edge_coverage(-0.5, {0, 1}, 0.2), 1 - 0.2 / 24, tiny);
  EXPECT_NEAR(bent_edge_coverage(-0.5, {0, 1}, -0.2), 1, tiny);
}

TEST(Straightened, StaysAsNearTheBentEdgeAsItSays) {
  for (double theta = 0; theta < kTau; theta += 0.07)
    for (double d = -0.7; d <= 0.7; d += 0.05) {
      const double moved = straightened(d, {std::cos(theta), std::sin(theta)}, 1.0) - d;
      EXPECT_GE(moved, 0);
      EXPECT_LE(moved, EdgeCoverageContract::kStraightenedPerBend);
    }
}

TEST(BentEdgeCoverage, OfABendOfZeroIsTheStraightOne) {
  EXPECT_EQ(bent_edge_coverage(0.2, {0.6, 0.8}, 0.0), straight_edge_coverage(0.2, {0.6, 0.8}));
}

}  // namespace
}  // namespace mien
