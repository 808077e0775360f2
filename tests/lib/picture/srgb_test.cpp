#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Srgb, GoesThereAndBackForEveryByte) {
  for (int v = 0; v < 256; ++v)
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(v / 255.0)) * 255, v, 1e-10);
}

TEST(Srgb, HasTheStandardsValues) {
  EXPECT_EQ(linear_from_srgb(0), 0);
  EXPECT_EQ(linear_from_srgb(1), 1);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114048223255, 1e-15);
  EXPECT_NEAR(linear_from_srgb(0.04045), linear_from_srgb(std::nextafter(0.04045, 1)), 1e-7);
}

TEST(Srgb, TakesBytesAsPeopleWriteThem) {
  const Color c = color_from_srgb255(255, 0, 51, 51);
  EXPECT_EQ(c.r, 1);
  EXPECT_EQ(c.g, 0);
  EXPECT_NEAR(c.b, linear_from_srgb(0.2), 1e-15);
  EXPECT_EQ(c.a, 0.2);
}

}  // namespace
}  // namespace mien
