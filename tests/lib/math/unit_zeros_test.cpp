#include "lib/math/unit_zeros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random/random.h"

namespace mien::test {

TEST(UnitZeros, AreTheRootsOfACubicThatLieInTheUnitInterval) {
  Random r(3);
  for (int i = 0; i < 50'000; ++i) {
    double x[3] = {r.between(-1, 2), r.between(-1, 2), r.between(-1, 2)};
    std::sort(x, x + 3);
    if (x[1] - x[0] < 1e-3 || x[2] - x[1] < 1e-3) continue;
    const auto f = [&](double t) {
      const double a = t - x[0], b = t - x[1], c = t - x[2];
      return ValueSlope{a * b * c, a * b + b * c + a * c};
    };
    const double c2 = -(x[0] + x[1] + x[2]), c1 = x[0] * x[1] + x[1] * x[2] + x[0] * x[2];
    std::vector<double> all, rising;
    for (int k = 0; k < 3; ++k)
      if (x[k] > 0 && x[k] < 1) {
        all.push_back(x[k]);
        if (k != 1) rising.push_back(x[k]);
      }
    const UnitZeros found = unit_zeros<Zeros::all>(1.0, c2, c1, f);
    ASSERT_EQ(found.count, int(all.size()));
    for (int k = 0; k < found.count; ++k) EXPECT_NEAR(found.t[k], all[k], 1e-14);
    const UnitZeros up = unit_zeros<Zeros::rising>(1.0, c2, c1, f);
    ASSERT_EQ(up.count, int(rising.size()));
    for (int k = 0; k < up.count; ++k) EXPECT_NEAR(up.t[k], rising[k], 1e-14);
  }
}

TEST(UnitZeros, FindsZerosAtTheEndsAndNoneInNothing) {
  const auto line = [](double t) { return ValueSlope{t, 1.0}; };
  EXPECT_EQ(unit_zeros<Zeros::all>(0.0, 0.0, 1.0, line).count, 1);
  const auto none = [](double) { return ValueSlope{1.0, 0.0}; };
  EXPECT_EQ(unit_zeros<Zeros::all>(0.0, 0.0, 0.0, none).count, 0);
  const auto nan = [](double) { return ValueSlope{std::nan(""), 0.0}; };
  EXPECT_EQ(unit_zeros<Zeros::all>(std::nan(""), 0.0, 0.0, nan).count, 0);
}

}  // namespace mien::test
