#include "lib/math/degrees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mien {
namespace {

constexpr long double kPerDegree = std::numbers::pi_v<long double> / 180;

TEST(Degrees, DirectionsAreTheLibrarys) {
  for (double degrees = -720; degrees <= 720; degrees += 0.37) {
    const glm::dvec2 at = direction_at(degrees);
    const long double angle = std::remainder(degrees, 360) * kPerDegree;
    EXPECT_NEAR(at.x, double(std::cos(angle)), 3e-16) << degrees;
    EXPECT_NEAR(at.y, double(std::sin(angle)), 3e-16) << degrees;
  }
}

TEST(Degrees, QuarterTurnsAreExact) {
  const glm::dvec2 all[]{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int i = -8; i <= 8; ++i) EXPECT_EQ(direction_at(90.0 * i), all[i & 3]) << i;
}

TEST(Degrees, AnglesAreTheLibrarys) {
  for (double degrees = -179.9; degrees < 180; degrees += 0.37)
    for (const double length : {1e-3, 0.1, 7.0}) {
      const glm::dvec2 way = length * direction_at(degrees);
      const long double angle = std::atan2((long double)(way.y), (long double)(way.x)) / kPerDegree;
      EXPECT_NEAR(degrees_of(way), double(angle), 1e-13) << degrees;
    }
  EXPECT_EQ(degrees_of({0, 0}), 0);
  EXPECT_NEAR(degrees_of({0, 2}), 90, 1e-13);
  EXPECT_NEAR(degrees_of({-2, 0}), 180, 1e-13);
}

}  // namespace
}  // namespace mien
