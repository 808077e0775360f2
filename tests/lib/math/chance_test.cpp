#include "lib/math/chance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace mien {
namespace {

TEST(Chance, IsEvenlySpread) {
  for (const std::uint32_t seed : {0u, 1u, 77u})
    for (const std::uint32_t stream : {0u, 1u, 2u}) {
      constexpr int kDraws = 20000, kBins = 20;
      std::array<int, kBins> bins{};
      double product = 0;
      for (int i = 0; i < kDraws; ++i) {
        const double u = chance(seed, stream, i - kDraws / 2);
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        ++bins[std::size_t(u * kBins)];
        product += (u - 0.5) * (chance(seed, stream, i + 1 - kDraws / 2) - 0.5);
      }
      double chi = 0;
      for (const int n : bins) chi += std::pow(n - kDraws / kBins, 2) / (kDraws / kBins);
      EXPECT_LT(chi, 50) << seed << " " << stream;  // 19 degrees of freedom: 0.01 %
      EXPECT_LT(std::abs(product / kDraws), 4 / 12.0 / std::sqrt(kDraws)) << "neighbours agree";
    }
}

TEST(Chance, TellsSeedsStreamsAndCountsApart) {
  std::set<double> seen;
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    for (std::uint32_t stream = 0; stream < 20; ++stream)
      for (const double count : {-1.0, 0.0, 1.0, 1e300}) seen.insert(chance(seed, stream, count));
  EXPECT_EQ(seen.size(), 1600u);
  EXPECT_EQ(chance(1, 2, 0.0), chance(1, 2, -0.0));
  static_assert(chance(3, 4, 5) == chance(3, 4, 5));
}

/// Pictures made from a seed stay what they are.
TEST(Chance, DoesNotChange) {
  EXPECT_EQ(chance(0, 0, 0), 0.65244848637403219);
  EXPECT_EQ(chance(5, 2, 17), 0.94333056350093469);
}

}  // namespace
}  // namespace mien
