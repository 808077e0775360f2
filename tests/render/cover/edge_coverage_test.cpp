#include "render/cover/edge_coverage.h"

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

}  // namespace
}  // namespace mien
