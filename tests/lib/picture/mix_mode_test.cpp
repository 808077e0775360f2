#include <mien/mix_mode.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(MixMode, HasTheStandardsNames) {
  EXPECT_EQ(kMixModes[std::size_t(MixMode::normal)], "normal");
  EXPECT_EQ(kMixModes[std::size_t(MixMode::multiply)], "multiply");
  EXPECT_EQ(kMixModes[std::size_t(MixMode::screen)], "screen");
}

}  // namespace
}  // namespace mien
