#include <gtest/gtest.h>

#include "sdf/from_face/heat.h"

#include <cmath>

namespace mien {
namespace {

TEST(Heat, GoesFromBlueToRedWithoutJumps) {
  EXPECT_GT(heat_rgb(0)[2], heat_rgb(0)[0]);
  EXPECT_GT(heat_rgb(1)[0], heat_rgb(1)[2]);
  for (int i = 0; i < 1000; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LE(std::abs(heat_rgb(i / 1000.0)[c] - heat_rgb((i + 1) / 1000.0)[c]), 1);
  EXPECT_EQ(heat_rgb(-3), heat_rgb(0));
  EXPECT_EQ(heat_rgb(7), heat_rgb(1));
  EXPECT_EQ(heat_rgb(NAN), heat_rgb(0));
}

}  // namespace
}  // namespace mien
