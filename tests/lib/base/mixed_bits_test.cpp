#include "lib/base/mixed_bits.h"

#include <gtest/gtest.h>

#include <bit>

namespace mien {
namespace {

TEST(MixedBits, AreThoseOfThePaper) {
  // The first numbers of SplitMix64 with seed 0: https://prng.di.unimi.it/splitmix64.c
  EXPECT_EQ(mixed_bits(0), 0xe220a8397b1dcdafu);
  EXPECT_EQ(mixed_bits(0x9e3779b97f4a7c15u), 0x6e789e6aa1b965f4u);
}

TEST(MixedBits, HalfOfThemChangeWithOne) {
  int changed = 0;
  for (int bit = 0; bit < 64; ++bit)
    changed += std::popcount(mixed_bits(12345) ^ mixed_bits(12345 ^ std::uint64_t{1} << bit));
  EXPECT_NEAR(changed / 64.0, 32, 2);
}

}  // namespace
}  // namespace mien
