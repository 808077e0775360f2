#include "tools/mien/batch/variable.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

TEST(Variable, FillsNumbersUpSoThatNamesSort) {
  const Variable frames{.name = "f", .kind = Variable::Kind::frames, .count = 100, .first = 5};
  EXPECT_EQ(frames.text(0), "005");
  EXPECT_EQ(frames.text(99), "104");
  EXPECT_EQ(frames.arguments(3), (std::vector<std::string>{"--frames", "8-8"}));
}

TEST(Variable, CallsRegionsByRowAndColumn) {
  const Variable regions{.name = "r",
                         .kind = Variable::Kind::regions,
                         .count = 24,
                         .columns = 12,
                         .rows = 2,
                         .words = {},
                         .rects = cut_regions(1200, 50, 12, 2)};
  EXPECT_EQ(regions.text(0), "r0c00");
  EXPECT_EQ(regions.text(23), "r1c11");
  EXPECT_EQ(regions.arguments(13), (std::vector<std::string>{"--region", "100,25,100,25"}));
}

// No pixel is left out, and none is drawn twice.
TEST(CutRegions, CoverThePictureOnce) {
  for (const int width : {1, 7, 255, 256, 1000, 4097, 70'000})
    for (const int columns : {1, 2, 3, 7}) {
      if (columns > width) continue;
      int x = 0;
      for (const PixelRect& rect : cut_regions(width, 10, columns, 1)) {
        EXPECT_EQ(rect.x, x);
        EXPECT_GT(rect.width, 0);
        if (width / columns >= 256) {
          EXPECT_EQ(x % 256, 0);
        }
        x += rect.width;
      }
      EXPECT_EQ(x, width);
    }
}

}  // namespace
}  // namespace mien::command
