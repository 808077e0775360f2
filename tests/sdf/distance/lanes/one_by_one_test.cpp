#include "sdf/distance/lanes/one_by_one.h"
#include <mien/shape.h>

#include <gtest/gtest.h>

namespace mien::batch {
namespace {

TEST(OneByOne, IsTheScalarDistanceAndMayReplaceTheCoordinates) {
  const Disc disc{{1, 0}, 2};
  float x[] = {1, 4, 7};
  const float y[] = {0, 4, 8};
  distances_one_by_one(disc, std::span<const float>(x), std::span<const float>(y),
                       std::span<float>(x));
  EXPECT_EQ(x[0], -2);
  EXPECT_EQ(x[1], 3);
  EXPECT_EQ(x[2], 8);
}

}  // namespace
}  // namespace mien::batch
