#include <mien/debug_picture.h>

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace mien {
namespace {

using Rgb = std::array<int, 3>;

Rgb pixel_of(const Image& image, int x, int y) {
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

TEST(DebugPicture, ShowsEveryOutlineAndBrighterWhatIsSeenOfIt) {
  const Image outlines = debug_picture(half_and_dome(), kView, DebugPicture::outlines).value();
  EXPECT_NE(pixel_of(outlines, 50, 80), pixel_of(outlines, 20, 80));  // the half plane's
  EXPECT_NE(pixel_of(outlines, 84, 25), pixel_of(outlines, 20, 80));  // the disc's
  const Image fragments = debug_picture(half_and_dome(), kView, DebugPicture::fragments).value();
  EXPECT_GT(pixel_of(fragments, 50, 80)[0], 200);  // black on white
  EXPECT_EQ(pixel_of(fragments, 20, 80), pixel_of(outlines, 20, 80));
}

TEST(DebugPicture, ShowsRegionsAndWhatLooksAlike) {
  const Image regions = debug_picture(half_and_dome(), kView, DebugPicture::regions).value();
  const Image looks = debug_picture(half_and_dome(), kView, DebugPicture::looks).value();
  EXPECT_NE(pixel_of(regions, 20, 80), pixel_of(regions, 80, 80));
  EXPECT_NE(pixel_of(regions, 80, 80), pixel_of(regions, 75, 25));
  EXPECT_NE(pixel_of(looks, 21, 81), pixel_of(looks, 81, 81));
  EXPECT_EQ(pixel_of(looks, 76, 24), (Rgb{255, 255, 255}));  // lit: it varies
}

TEST(DebugPicture, ShowsRegionsWhereTheyAre) {
  const Image regions = debug_picture(half_and_dome(), kView, DebugPicture::regions).value();
  EXPECT_NE(pixel_of(regions, 75, 25), pixel_of(regions, 90, 25));  // in the disc, and beside it
  EXPECT_EQ(pixel_of(regions, 75, 60), pixel_of(regions, 90, 60));  // both below it
}

TEST(DebugPicture, EachRegionHasAColourOfItsOwn) {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {1, 1, 1, 1});
  for (int i = 0; i < 6; ++i)
    build.layer("disc", build.shape(Disc{{-40 + 16 * i, 0}, 6}), {{0.1 * i, 0, 0, 1}});
  const Image regions =
      debug_picture(std::move(build).finish(), kView, DebugPicture::regions).value();
  std::set<Rgb> colours{pixel_of(regions, 50, 10)};
  for (int i = 0; i < 6; ++i) colours.insert(pixel_of(regions, 10 + 16 * i, 50));
  EXPECT_EQ(colours.size(), 7u);
}

TEST(DebugPicture, OfARegionIsThatOfTheWhole) {
  View view = kView;
  view.region = PixelRect{58, 11, 37, 64};
  for (int kind = 0; kind < 6; ++kind) {
    const Image whole = debug_picture(half_and_dome(), kView, DebugPicture(kind)).value(),
                part = debug_picture(half_and_dome(), view, DebugPicture(kind)).value();
    ASSERT_EQ(part.width, 37);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 37; ++x)
        ASSERT_EQ(pixel_of(part, x, y), pixel_of(whole, 58 + x, 11 + y))
            << kind << " " << x << " " << y;
  }
}

/// Large pictures are arranged in parts: what is seen first in one of them does not tell how the rest is shown.
TEST(DebugPicture, WhatLooksAlikeDoesSoAllTheWayDown) {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {1, 1, 1, 1});
  build.layer("low corner", build.shape(Disc{{-50, -50}, 20}), {{0, 0, 1, 1}});
  build.layer("high corner", build.shape(Disc{{-50, 50}, 20}), {{0, 1, 0, 1}});
  build.layer("half", build.shape(HalfPlane{{1, 0}, 0.25}), {{0, 0, 0, 1}});
  const Scene scene = std::move(build).finish();
  const View view{.width = 700, .height = 700};
  for (const auto which : {DebugPicture::looks, DebugPicture::regions}) {
    const Image image = debug_picture(scene, view, which).value();
    for (int y = 30; y < 670; y += 20) {
      EXPECT_EQ(pixel_of(image, 300, y), pixel_of(image, 300, 1)) << y;
      EXPECT_EQ(pixel_of(image, 600, y), pixel_of(image, 600, 1)) << y;
    }
  }
}

TEST(DebugPicture, DrawsIsolinesOfTheNearestOutline) {
  const Image distance = debug_picture(half_and_dome(), kView, DebugPicture::distance).value();
  EXPECT_EQ(pixel_of(distance, 50, 90), (Rgb{255, 255, 255}));
  const Rgb inside = pixel_of(distance, 45, 90), outside = pixel_of(distance, 55, 90),
            line = pixel_of(distance, 60, 90);
  EXPECT_GT(inside[2], inside[0]);
  EXPECT_GT(outside[0], outside[2]);
  EXPECT_LT(line[0], outside[0]);
}

TEST(DebugPicture, ShowsNormalsOfReliefs) {
  const Image normals = debug_picture(half_and_dome(), kView, DebugPicture::normals).value();
  EXPECT_EQ(pixel_of(normals, 10, 90), (Rgb{128, 128, 255}));
  EXPECT_GT(pixel_of(normals, 79, 25)[0], 150);  // right of the dome's top
  EXPECT_LT(pixel_of(normals, 70, 25)[0], 106);
  EXPECT_GT(pixel_of(normals, 75, 20)[1], 150);  // above it
}

}  // namespace
}  // namespace mien
