#include "render/blend/transfer.h"

#include <gtest/gtest.h>

#include <limits>

namespace mien {
namespace {

TEST(Transfer, EveryLevelComesBackAsItself) {
  for (int top : {255, 65535})
    for (int i = 0; i <= top; ++i)
      ASSERT_EQ(level(srgb_from_linear(linear_from_srgb(double(i) / top)), top), i) << "of " << top;
}

TEST(Transfer, HasTheStandardsValues) {
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
  EXPECT_EQ(linear_from_srgb(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-15);
}

TEST(Level, RoundsHalvesUpAndClamps) {
  EXPECT_EQ(level(0.5, 255), 128);
  EXPECT_EQ(level(-3.0, 255), 0);
  EXPECT_EQ(level(2.0, 255), 255);
  EXPECT_EQ(level(std::numeric_limits<double>::quiet_NaN(), 255), 0);
}

TEST(EncodingSlope, IsTheSlopeOfTheEncoding) {
  for (const double v : {0.001, 0.003, 0.0032, 0.01, 0.2, 0.99}) {
    const double h = 1e-6 * v,
                 slope = (srgb_from_linear(v + h) - srgb_from_linear(v - h)) / (2 * h);
    EXPECT_NEAR(encoding_slope(v), slope, 1e-6 * slope) << v;
  }
  EXPECT_EQ(encoding_slope(0.0), 12.92);
  EXPECT_EQ(encoding_slope(-1.0), 12.92);
}

}  // namespace
}  // namespace mien
