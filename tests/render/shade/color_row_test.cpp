#include "render/shade/color_row.h"

#include <gtest/gtest.h>

namespace mien::test {
namespace {

TEST(ColorRow, HasRoomForWhatLanesReadBeyondTheLastAndKeepsIt) {
  ColorRow row;
  row.room_for(5);
  EXPECT_GE(row.a.size(), 5 + kColorSpare);
  const float* const before = row.planes().r;
  row.room_for(3);
  EXPECT_EQ(row.planes().r, before);
}

}  // namespace
}  // namespace mien::test
