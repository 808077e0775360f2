#include <mien/view.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

const Canvas kWide{.box = {{0, 0}, {2, 1}}, .y_up = true};

TEST(PixelFromFace, MeetShowsTheWholeCanvasCentred) {
  const auto map = pixel_from_face(kWide, {.width = 100, .height = 100});
  EXPECT_EQ(map.scale(), 50);
  EXPECT_EQ(map({1, 0.5}), glm::dvec2(0, 0));    // the middle of the picture is the origin
  EXPECT_EQ(map({0, 1}), glm::dvec2(-50, -25));  // y up in the face, down in pixels
  EXPECT_TRUE(map.mirrors());
}

TEST(PixelFromFace, SliceFillsThePicture) {
  const auto map = pixel_from_face(kWide, {.width = 100, .height = 100, .fit = Fit::slice});
  EXPECT_EQ(map.scale(), 100);
  EXPECT_EQ(map({0, 0}), glm::dvec2(-100, 50));
}

TEST(PixelFromFace, MirrorImagesHaveOppositeCoordinates) {
  const Canvas canvas{.box = {{-0.5, -0.3}, {0.5, 0.3}}};
  const auto map = pixel_from_face(canvas, {.width = 997, .height = 601});
  for (const double x : {0.1, 0.37, 1.0 / 3}) EXPECT_EQ(map({x, 0.1}).x, -map({-x, 0.1}).x);
}

TEST(DrawnRect, IsTheRegionAsFarAsItLiesInThePicture) {
  View view{.width = 100, .height = 50};
  EXPECT_EQ(drawn_rect(view).width, 100);
  view.region = PixelRect{90, -10, 2147483647, 20};
  const PixelRect r = drawn_rect(view);
  EXPECT_EQ(r.x, 90);
  EXPECT_EQ(r.y, 0);
  EXPECT_EQ(r.width, 10);
  EXPECT_EQ(r.height, 10);
}

}  // namespace
}  // namespace mien
