#include <mien/face_paint.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(FacePaint, IsNothingUnlessSaidOtherwise) {
  EXPECT_EQ(FaceRelief{}.profile, FaceRelief::Profile::flat);
  EXPECT_TRUE(FaceRelief{}.domes.empty());
  EXPECT_EQ(FaceGroup{}.opacity, -1);
  EXPECT_GT(FaceLight{}.direction.z, 0);
  EXPECT_EQ(FaceLight{}.ambient, 0.35) << "as docs/face-format.md tells";
}

}  // namespace
}  // namespace mien
