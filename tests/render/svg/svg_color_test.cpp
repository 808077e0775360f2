#include "render/svg/svg_color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

TEST(SvgColor, IsStraightInEightBits) {
  EXPECT_EQ(svg_color({1, 0, 0.5, 1}), "#ff0080");
  EXPECT_EQ(svg_color({0.25, 0, 0.1, 0.5}), "#800033");
  EXPECT_EQ(svg_color({2, -1, 0, 1}), "#ff0000");
  EXPECT_EQ(svg_color({0, 0, 0, 0}), "#000000");
}

TEST(SvgColor, OpacityIsSaidWhereThereIsOne) {
  EXPECT_EQ(svg_opacity("opacity", 1), "");
  EXPECT_EQ(svg_opacity("opacity", 7), "");
  EXPECT_EQ(svg_opacity("opacity", 0.25), " opacity=\".25\"");
  EXPECT_EQ(svg_opacity("opacity", -1), " opacity=\"0\"");
  EXPECT_EQ(svg_opacity("opacity", std::nan("")), " opacity=\"0\"");
}

}  // namespace
}  // namespace mien
