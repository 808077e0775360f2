#include <gtest/gtest.h>

#include "tools/mien/film/frame_names.h"

namespace mien::command {
namespace {

TEST(FrameNames, OnePlaceForTheNumber) {
  EXPECT_EQ((*read_frame_names("a/%05d.png"))->of(17), "a/00017.png");
  EXPECT_EQ((*read_frame_names("%d%%.png"))->of(123456), "123456%.png");
  EXPECT_FALSE(read_frame_names("film.mp4")->has_value());
  for (const char* bad : {"%", "%5", "%s.png", "%d%d", "%05x", "%12345d"})
    EXPECT_FALSE(read_frame_names(bad)) << bad;
}

}  // namespace
}  // namespace mien::command
