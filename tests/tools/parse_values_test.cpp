// What options take; the sentences for what they do not are in bad_use_test.cpp.

#include "tools/mien/cli/parse_values.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

TEST(ReadSize, BothSidesOrTheLonger) {
  EXPECT_EQ(read_size("7680x4320", 1)->width, 7680);
  EXPECT_EQ(read_size("7680x4320", 1)->height, 4320);
  EXPECT_EQ(read_size("1000", 2.5)->height, 400);
  EXPECT_EQ(read_size("1000", 0.25)->width, 250);
  EXPECT_EQ(read_size("10", 1e9)->height, 1) << "never less than a pixel";
  EXPECT_EQ(read_size("1048576x1", 1)->width, 1048576);
  for (const char* text : {"+5x5", " 5x5", "5x5 ", "5X5", "5x", "x5", "5.0x5", "٥x5"})
    EXPECT_FALSE(read_size(text, 1)) << text;
}

TEST(ReadRegion, InsideThePicture) {
  const auto region = read_region("1,2,9,8", {10, 10});
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x, 1);
  EXPECT_EQ(region->y, 2);
  EXPECT_EQ(region->width, 9);
  EXPECT_EQ(region->height, 8);
  EXPECT_TRUE(read_region("0,0,10,10", {10, 10}));
  EXPECT_FALSE(read_region("-1,0,5,5", {10, 10}));
  EXPECT_FALSE(read_region("2,2,9,8", {10, 10}));
}

TEST(ReadBackground, WithAndWithoutTheHash) {
  EXPECT_EQ(*read_background("#ffffff"), (Color{1, 1, 1, 1}));
  EXPECT_EQ(*read_background("ffffff"), (Color{1, 1, 1, 1}));
  EXPECT_EQ(read_background("00000000")->a, 0);
  EXPECT_EQ(read_background("transparent")->a, 0);
  EXPECT_FALSE(read_background("##ffffff"));
}

TEST(ReadMemory, WithUnits) {
  EXPECT_EQ(*read_memory("4096"), 4096u);
  EXPECT_EQ(*read_memory("4K"), 4096u);
  EXPECT_EQ(*read_memory("3G"), 3ull << 30);
  EXPECT_EQ(*read_memory("2T"), 2ull << 40);
  for (const char* text :
       {"0", "-1", "K", "1.5G", "9999999999999T", "18446744073709551616", "4k"}) {
    EXPECT_FALSE(read_memory(text)) << text;
  }
}

TEST(ReadTime, AnyFiniteNumber) {
  EXPECT_EQ(*read_time("-1.25"), -1.25);
  EXPECT_EQ(*read_time("1e3"), 1000);
  EXPECT_FALSE(read_time("inf"));
  EXPECT_FALSE(read_time("1s"));
}

TEST(ReadShare, From0To1) {
  EXPECT_EQ(*read_share("unwrap", "0.25"), 0.25);
  EXPECT_EQ(*read_share("unwrap", "1"), 1);
  EXPECT_EQ(sentence(read_share("unwrap", "1.5").error()),
            "--unwrap 1.5: expected a number from 0 to 1");
  for (const char* text : {"-0.1", "nan", "", "a"})
    EXPECT_FALSE(read_share("unwrap", text)) << text;
}

}  // namespace
}  // namespace mien::command
