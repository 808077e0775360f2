#include "lib/base/bit_cast.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace mien {
namespace {

TEST(BitCast, KeepsEveryBit) {
  EXPECT_EQ(mien::bit_cast<std::uint64_t>(1.0), 0x3ff0000000000000u);
  EXPECT_EQ(mien::bit_cast<double>(std::uint64_t{0xc000000000000000}), -2.0);
  static_assert(mien::bit_cast<std::uint32_t>(1.0f) == 0x3f800000u);
}

}  // namespace
}  // namespace mien
