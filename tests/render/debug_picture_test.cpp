#include <mien/render/debug_picture.h>

#include <gtest/gtest.h>

#include <array>

namespace mien {
namespace {

using Rgb = std::array<int, 3>;

Rgb pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.row(y) + 4 * x;
  return {p[0], p[1], p[2]};
}

Scene half_and_dome() {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {1, 1, 1, 1});
  build.layer("half", build.shape(HalfPlane{{1, 0}, 0.25}), {{0, 0, 0, 1}});
  build.layer(
      "dome", build.shape(Disc{{25, 25}, 10}),
      {.color = {1, 0, 0, 1},
       .relief = shared(Relief{.domes = {{.center = {25, 25}, .radii = {9, 9}, .height = 9}}})});
  return std::move(build).finish();
}

constexpr View kView{.width = 100, .height = 100};

TEST(DebugPicture, ShowsWhatBecameOfEverySquare) {
  const Image tiles = debug_picture(half_and_dome(), kView, DebugPicture::tiles);
  EXPECT_EQ(pixel(tiles, 50, 80), (Rgb{60, 170, 90}));   // one edge
  EXPECT_EQ(pixel(tiles, 75, 25), (Rgb{150, 90, 200}));  // lit
  const Rgb fill = pixel(tiles, 5, 90);
  EXPECT_GT(fill[2], fill[0]);
}

TEST(DebugPicture, DrawsIsolinesOfTheNearestOutline) {
  const Image distance = debug_picture(half_and_dome(), kView, DebugPicture::distance);
  EXPECT_EQ(pixel(distance, 50, 90), (Rgb{255, 255, 255}));
  const Rgb inside = pixel(distance, 45, 90), outside = pixel(distance, 55, 90),
            line = pixel(distance, 60, 90);
  EXPECT_GT(inside[2], inside[0]);
  EXPECT_GT(outside[0], outside[2]);
  EXPECT_LT(line[0], outside[0]);
}

TEST(DebugPicture, ShowsCoverageWhereAnOutlineRuns) {
  const Image coverage = debug_picture(half_and_dome(), kView, DebugPicture::coverage);
  EXPECT_EQ(pixel(coverage, 50, 90), (Rgb{64, 64, 64}));  // a quarter
  EXPECT_EQ(pixel(coverage, 10, 90), (Rgb{18, 26, 48}));
}

TEST(DebugPicture, ShowsNormalsOfReliefs) {
  const Image normals = debug_picture(half_and_dome(), kView, DebugPicture::normals);
  EXPECT_EQ(pixel(normals, 10, 90), (Rgb{128, 128, 255}));
  EXPECT_GT(pixel(normals, 79, 25)[0], 150);  // right of the dome's top
  EXPECT_LT(pixel(normals, 70, 25)[0], 106);
  EXPECT_GT(pixel(normals, 75, 20)[1], 150);  // above it
}

}  // namespace
}  // namespace mien
