#include "lib/picture/color_text.h"
#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(ColorText, ReadsSixAndEightDigits) {
  EXPECT_EQ(color_from_text("#f7DB9c"), color_from_srgb255(247, 219, 156));
  EXPECT_EQ(color_from_text("#00000080"), color_from_srgb255(0, 0, 0, 128));
}

TEST(ColorText, RefusesEverythingElse) {
  for (const char* text : {"", "#", "f7db9c", "#f7db9", "#f7db9cf", "#f7db9c0", "#g7db9c",
                           "#f7db9c000", " #f7db9c", "# 7db9c", "red"})
    EXPECT_FALSE(color_from_text(text)) << text;
}

}  // namespace
}  // namespace mien
