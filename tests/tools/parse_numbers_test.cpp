#include <gtest/gtest.h>

#include "tools/mien/cli/parse_values.h"

namespace mien::command {
namespace {

TEST(MotionValues, Frames) {
  EXPECT_EQ(read_frames("3-7")->count(), 5);
  EXPECT_EQ(read_frames("17")->first, 17);
  EXPECT_EQ(read_frames("17")->last, 17);
  for (const char* bad : {"", "-", "7-3", "-1", "1-", "1-2-3", "a-b", "1.5-2", "0-10000000"})
    EXPECT_FALSE(read_frames(bad)) << bad;
}

TEST(MotionValues, FramesASecond) {
  EXPECT_EQ(*read_fps("24"), 24);
  EXPECT_NEAR(*read_fps("30000/1001"), 29.97, 0.001);
  for (const char* bad : {"", "0", "-1", "1/0", "nan", "inf", "1e9", "30/", "/2", "30fps"})
    EXPECT_FALSE(read_fps(bad)) << bad;
}

TEST(MotionValues, NumbersInARange) {
  EXPECT_EQ(*read_whole("--a", "5", 1, 9), 5);
  EXPECT_EQ(sentence(read_whole("--a", "10", 1, 9).error()),
            "--a 10: expected a whole number from 1 to 9");
  EXPECT_EQ(*read_real("--a", "0.5", 0, 1), 0.5);
  EXPECT_FALSE(read_real("--a", "nan", 0, 1));
  EXPECT_FALSE(read_real("--a", "1.01", 0, 1));
}

}  // namespace
}  // namespace mien::command
