#include "render/shade/ramp/piece_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

TEST(PieceIndex, BucketsBeginWithinTwoPiecesOfTheirPlacesUnlessCrowded) {
  Random r(3);
  int crowded = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> begins{0.0};
    const int count = int(r.between(1, 60));
    const double alike = i % 3 ? 0.0 : 6.0;  // else some lie close together, many in one bucket
    for (int k = 1; k < count; ++k)
      begins.push_back(begins.back() + std::pow(10, r.between(alike - 6, 0)));
    PieceIndex index;
    index.begins = begins;
    index.make(i % 2 ? begins.back() + 0.5 : 0.0);
    crowded += index.crowded;
    for (int k = 0; k < 200; ++k) {
      const double s = r.between(i % 2 ? 0 : -1, 1) * (begins.back() + 0.4);
      const double bucket = std::clamp(s * index.per_bucket, 0.0, double(index.buckets.size() - 1));
      const auto piece = std::size_t(index.buckets[std::size_t(bucket)]);
      ASSERT_TRUE(piece == 0 || index.begins[piece] <= s * (1 + 1e-15));
      if (!index.crowded) {
        ASSERT_TRUE(piece + 3 >= index.begins.size() || s < index.begins[piece + 3]);
      }
    }
  }
  EXPECT_GT(crowded, 50);
  EXPECT_LT(crowded, 250);
}

}  // namespace
}  // namespace mien::test
