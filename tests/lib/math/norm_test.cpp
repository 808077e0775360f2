#include "lib/math/norm.h"

#include <gtest/gtest.h>

#include "tests/support/exact/real128.h"
#include "tests/support/random/random.h"

namespace mien::test {

TEST(Norm, IsTheLengthAtEverySize) {
  Random r(1);
  for (int i = 0; i < 10'000; ++i) {
    const double k = r.size(-300, 300);
    const glm::dvec2 v = k * r.point(-1, 1);
    const Real x = Real(v.x), y = Real(v.y), exact = sqrt(x * x + y * y);
    EXPECT_LE(double(abs(norm(v) - exact) / exact), 0x1p-51) << v.x << ' ' << v.y;
  }
  EXPECT_EQ(norm({0, 0}), 0);
  EXPECT_EQ(norm({3e-310, 4e-310}), 5e-310);
  EXPECT_TRUE(std::isnan(norm({std::nan(""), 1})));
}

}  // namespace mien::test
