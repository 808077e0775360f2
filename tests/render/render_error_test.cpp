#include "render/render_error.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(RenderError, NamesTheSizesThatCannotBeDrawn) {
  EXPECT_TRUE(drawable({.width = 1, .height = View::kMaxSide}));
  EXPECT_FALSE(drawable({.width = 0, .height = 8}));
  EXPECT_FALSE(drawable({.width = 8, .height = View::kMaxSide + 1}));
  EXPECT_EQ(invalid_size({.width = 0, .height = 8}).what,
            "a picture of 0 x 8 pixels: sides are 1 ... 1048576");
}

TEST(RenderError, SaysHowLargeThePictureIsThatMemoryDoesNotHold) {
  EXPECT_EQ(out_of_memory({0, 0, 30, 20}).what, "memory ran out: the picture has 30 x 20 pixels");
}

}  // namespace
}  // namespace mien
