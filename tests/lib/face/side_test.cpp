#include <mien/side.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Side, NamesFeaturesAndControls) {
  EXPECT_EQ(feature_of_side("iris", Side::left), "iris.left");
  EXPECT_EQ(feature_of_side("iris", Side::none), "iris");
  EXPECT_EQ(control_of_side("gaze.x", Side::right), "gaze.right.x");
  EXPECT_EQ(control_of_side("blink", Side::left), "blink.left");
}

TEST(Side, HasAnOther) {
  EXPECT_EQ(other(Side::left), Side::right);
  EXPECT_EQ(other(Side::right), Side::left);
  EXPECT_EQ(other(Side::none), Side::none);
}

}  // namespace
}  // namespace mien
