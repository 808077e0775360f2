#include "lib/math/bounded_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien {
namespace {

double norm2(const BoundedLeastSquares& p, const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t r = 0; r < p.rows; ++r) {
    double left = -p.right[r];
    for (std::size_t c = 0; c < x.size(); ++c) left += p.columns[c * p.rows + r] * x[c];
    sum += left * left;
  }
  for (const double each : x) sum += p.damping * each * each;
  return sum;
}

/// The conditions of Karush, Kuhn and Tucker: no variable could better the sum by moving within its
/// bounds.
TEST(BoundedLeastSquares, NoVariableCanBetterIt) {
  test::Random random(3);
  for (int i = 0; i < 300; ++i) {
    BoundedLeastSquares p;
    const std::size_t count = 1 + std::size_t(random.below(8));
    p.rows = 1 + std::size_t(random.below(10));
    for (std::size_t k = 0; k < p.rows * count; ++k) p.columns.push_back(random.between(-1, 1));
    for (std::size_t k = 0; k < p.rows; ++k) p.right.push_back(random.between(-3, 3));
    for (std::size_t k = 0; k < count; ++k) {
      p.lo.push_back(random.between(-1, 0.3)), p.hi.push_back(p.lo.back() + random.unit());
    }
    p.damping = random.chance(0.5) ? 0 : 0.01;
    const std::vector<double> x = solve(p);
    const double least = norm2(p, x);
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_GE(x[k], p.lo[k]);
      EXPECT_LE(x[k], p.hi[k]);
      for (const double by : {-1e-4, 1e-4}) {
        std::vector<double> moved = x;
        moved[k] = std::min(std::max(moved[k] + by, p.lo[k]), p.hi[k]);
        EXPECT_GE(norm2(p, moved), least - 1e-11) << i;
      }
    }
  }
}

TEST(BoundedLeastSquares, WithoutNeedOfBoundsIsTheOrdinarySolution) {
  const BoundedLeastSquares p{{1, 0, 1, 1}, 2, {3, 1}, {-10, -10}, {10, 10}};
  const std::vector<double> x = solve(p);  // x0 + x1 = 3, x1 = 1
  EXPECT_NEAR(x[0], 2, 1e-12);
  EXPECT_NEAR(x[1], 1, 1e-12);
}

}  // namespace
}  // namespace mien
