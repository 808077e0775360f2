#include "lib/math/bracketed_root.h"

#include <gtest/gtest.h>

namespace mien::test {

TEST(BracketedRoot, FindsARootHoweverFarTheEndsAre) {
  const double big = std::numeric_limits<double>::max();
  for (const double root : {1e-300, 3.0, -1e-5, 1e200, 0.0}) {
    int evaluations = 0;
    const auto f = [&](double x) {
      ++evaluations;
      return ValueSlope{std::atan(x - root),
                        1 / (1 + (x - root) * (x - root))};  // Newton alone escapes
    };
    EXPECT_NEAR(bracketed_root(f, -big, big, -1, 1e10, 200), root, 1e-15 * std::abs(root) + 1e-16);
    EXPECT_LE(evaluations, 200);
  }
}

TEST(BracketedRoot, EndsWhereTheFunctionIsAStep) {
  const auto step = [](double x) { return ValueSlope{x < 0.3 ? -1.0 : 1.0, 0.0}; };
  EXPECT_NEAR(bracketed_root(step, -1e300, 1e300, -1, 7, 300), 0.3, 1e-16);
}

TEST(MiddleByRank, HalvesTheNumbersNotTheLength) {
  EXPECT_EQ(middle_by_rank(-1, 1), 0);
  EXPECT_NEAR(middle_by_rank(1, 16), 4, 1);
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(middle_by_rank(1, next) == 1 || middle_by_rank(1, next) == next);
}

}  // namespace mien::test
