#include "lib/math/quartic.h"

#include <gtest/gtest.h>

#include "tests/support/exact/real128.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

TEST(SolveQuartic, FindsEveryRootOfAProductOfLinesAndCircles) {
  Random r(1);
  for (int i = 0; i < times(20'000); ++i) {
    const int real = 2 * r.below(3);
    Polynomial f{Real(r.between(0.5, 2) * r.sign())};
    std::vector<double> roots;
    for (int k = 0; k < real; ++k) {
      const double x = r.between(-2, 2);
      roots.push_back(x);
      f = f * Polynomial{-x, 1};
    }
    for (int k = real; k < 4; k += 2) {
      const Real re = r.between(-2, 2), im = r.between(0.1, 2);
      f = f * Polynomial{re * re + im * im, -2 * re, 1};
    }
    std::sort(roots.begin(), roots.end());
    bool apart = true;
    for (int k = 1; k < real; ++k) apart &= roots[k] - roots[k - 1] > 1e-3;
    if (!apart) continue;
    const QuarticRoots x =
        solve_quartic(double(f[4]), double(f[3]), double(f[2]), double(f[1]), double(f[0]));
    ASSERT_EQ(x.count, real);
    for (int k = 0; k < real; ++k) EXPECT_NEAR(x.x[k], roots[k], 1e-5);
    for (int k = 0; k < real; ++k) {
      Real size = 0, power = 1;
      const Polynomial rounded{double(f[0]), double(f[1]), double(f[2]), double(f[3]),
                               double(f[4])};
      for (const Real c : rounded) size += abs(c * power), power *= x.x[k];
      EXPECT_LE(double(abs(value(rounded, x.x[k])) / size), 4 * 0x1p-52);
    }
  }
}

TEST(SolveQuartic, GivesMultipleRootsOnceAndSolvesLowerDegrees) {
  EXPECT_EQ(solve_quartic(1, 0, -2, 0, 1).count, 2);  // (x² − 1)²
  EXPECT_EQ(solve_quartic(1, 0, 0, 0, 0).count, 1);
  EXPECT_EQ(solve_quartic(1, 0, 0, 0, 1).count, 0);
  EXPECT_EQ(solve_quartic(0, 1, 0, 0, -8).x[0], 2);
  EXPECT_EQ(solve_quartic(0, 0, 1, 0, -4).count, 2);
  EXPECT_EQ(solve_quartic(0, 0, 0, 0, 0).count, -1);
  EXPECT_EQ(solve_quartic(std::nan(""), 0, 0, 0, 0).count, 0);
}

TEST(SolveQuartic, FindsFarRootsBesideNearOnes) {
  const QuarticRoots r = solve_quartic(1e-12, 0, -1, 0, 1);
  ASSERT_EQ(r.count, 4);
  EXPECT_NEAR(r.x[0], -1e6, 1e-5);
  EXPECT_NEAR(r.x[1], -1, 1e-11);
  EXPECT_NEAR(r.x[2], 1, 1e-11);
  EXPECT_NEAR(r.x[3], 1e6, 1e-5);
}

}  // namespace
}  // namespace mien::test
