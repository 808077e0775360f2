#include "sdf/distance/lanes/one_by_one.h"
#include <mien/shape.h>

#include <gtest/gtest.h>

#include <algorithm>

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

/// Which kernel ran, as a distance.
void seven(const Disc&, int frame, const float*, const float*, size_t count, float* d) {
  std::fill_n(d, count, float(frame + 7));
}

TEST(OneByOne, TakesTheKernelWhereThereIsAFrame) {
  const Disc disc{{1, 0}, 2};
  const float x[] = {1, 4}, y[] = {0, 4};
  float d[2];
  const auto by = [&](std::optional<int> frame) {
    distances_by(seven, frame, disc, std::span<const float>(x), std::span<const float>(y),
                 std::span<float>(d));
    return d[1];
  };
  EXPECT_EQ(by(1), 8);
  EXPECT_EQ(by({}), 3);
}

}  // namespace
}  // namespace mien::batch
