#include <mien/render.h>
#include "render/rows/drawing.h"

#include <mien/error_map.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

/// Discs over each other, some of them opaque, some in groups, some lit, some with a hole.
Scene crowd(std::uint64_t seed, std::size_t layers, double opaque = 0.8) {
  SceneBuilder build({.box = {{0, 0}, {100, 60}}}, {0.2, 0.3, 0.4, 1});
  Random r(seed);
  for (std::size_t i = 0; i < layers; ++i) {
    const Disc disc{{r.between(-5, 105), r.between(-5, 65)}, r.between(0.3, 9)};
    const Area whole = build.shape(disc);
    const Area hole = build.shape(Disc{disc.center, 0.4 * disc.radius});
    Paint paint{.color = {r.unit(), r.unit(), r.unit(), r.chance(opaque) ? 1.0 : r.unit()}};
    if (r.chance(0.02))
      paint.relief = shared({.area = whole, .profile = Profile::bevel, .width = 2, .height = 1});
    const bool grouped = r.chance(0.05);
    if (grouped) build.open_group("group", 0.5, {}, MixMode(i % kMixModes.size()));
    build.layer("disc", r.chance(0.2) ? build.subtract(whole, hole) : whole, paint);
    if (grouped) build.close_group();
  }
  return std::move(build).finish();
}

std::vector<std::byte> drawn(const Scene& scene, const View& view, bool whole) {
  Drawing drawing;
  if (whole)
    drawing.make_whole(scene, view, Depth::u8);
  else
    drawing.make(scene, view, Depth::u8);
  const std::size_t stride = 4 * std::size_t(view.width);
  std::vector<std::byte> pixels(stride * std::size_t(view.height));
  StripScratch scratch;
  RenderStats stats;
  for (int strip = 0; strip * Drawing::kRows < view.height; ++strip)
    drawing.draw_strip(strip, {pixels.data(), stride, drawn_rect(view)}, scratch, stats);
  return pixels;
}

TEST(Crowd, DrawnInWindowsIsThePictureOfOneSweep) {
  const Scene scene = crowd(1, Crowd::kMany);
  ASSERT_TRUE(Crowd::is_one(scene));
  for (const bool y_up : {true, false}) {
    const View view{
        .width = 250, .height = y_up ? 150 : 120, .blend = Blend::srgb, .dither = false};
    const auto whole = drawn(scene, view, true), windows = drawn(scene, view, false);
    for (std::size_t i = 0; i < whole.size(); ++i)
      ASSERT_LE(std::abs(int(whole[i]) - int(windows[i])), 1) << i / 4 % 250 << ' ' << i / 1000;
  }
}

TEST(Crowd, OfAPartIsThatPartOfTheWhole) {
  for (const double opaque : {0.8, 0.0}) {
    const Scene scene = crowd(2, Crowd::kMany, opaque);
    const View view{.width = 203, .height = 122};
    const Image whole = test::rendered(scene, view);
    int threads = 1;
    for (const PixelRect part :
         {PixelRect{0, 0, 203, 122}, {0, 0, 1, 1}, {17, 15, 60, 40}, {190, 100, 13, 22}}) {
      View some = view;
      some.region = part;
      const Image piece =
          test::rendered(scene, some, {.threads = {.count = threads = threads % 7 + 2}});
      for (int y = 0; y < part.height; ++y)
        ASSERT_EQ(std::memcmp(piece.row(y), whole.row(y + part.y) + 4 * part.x,
                              4 * std::size_t(part.width)),
                  0);
    }
  }
}

TEST(Crowd, OfTranslucentLayersIsTheExactPicture) {
  SceneBuilder build({.box = {{0, 0}, {40, 30}}}, {0.2, 0.3, 0.4, 1});
  Random r(3);
  for (std::size_t i = 0; i < Crowd::kMany; ++i)
    build.layer("disc",
                build.shape(Disc{{r.between(-5, 45), r.between(-5, 35)}, r.between(0.5, 4)}),
                {{r.unit(), r.unit(), r.unit(), 0.5}});
  const Scene scene = std::move(build).finish();
  for (const Depth depth : {Depth::u8, Depth::u16}) {
    for (const Blend blend : {Blend::srgb, Blend::linear}) {
      const View view{.width = 80, .height = 60, .blend = blend};
      const ExactTruth truth(scene, view);
      const Image image = test::rendered(scene, view, {.depth = depth});
      const int top = depth == Depth::u8 ? 255 : 65535;
      for (int k = 0; k < 4; ++k) {
        const int x = int(80 * r.unit()), y = int(60 * r.unit());
        const glm::dvec4 exact = truth.levels(x, y, top);
        for (int c = 0; c < 4; ++c) {
          const int drawn = depth == Depth::u8
                                ? int(image.row(y)[4 * x + c])
                                : reinterpret_cast<const std::uint16_t*>(image.row(y))[4 * x + c];
          ASSERT_NEAR(drawn, exact[c], depth == Depth::u8 ? 1.0 : 32.0) << x << ' ' << y;
        }
      }
    }
  }
}

TEST(Crowd, WhatIsLeftOutShowsLessThanItMay) {
  for (int above = 6; above < 24; ++above) {
    SceneBuilder build({.box = {{0, 0}, {16, 16}}}, {0, 0, 0, 1});
    const Area all = build.shape(Disc{{8, 8}, 100});
    for (std::size_t i = 0; i < Crowd::kMany; ++i) build.layer("white", all, {{1, 1, 1, 1}});
    for (int i = 0; i < above; ++i) build.layer("black", all, {{0, 0, 0, 0.5}});
    const Scene scene = std::move(build).finish();
    const View view{.width = 16, .height = 16, .blend = Blend::srgb};
    const Image image = test::rendered(scene, view, {.depth = Depth::u16});
    const double level = reinterpret_cast<const std::uint16_t*>(image.row(8))[0];
    const double off = std::abs(level - std::ldexp(65535.0, -above));
    EXPECT_LE(off, 32 * Crowd::kUnseen + 0.5) << above;
    const double told =
        257 * double(error_map(scene, view, {.depth = Depth::u16})->levels[8 * 16 + 8]);
    EXPECT_LE(off, told + 0.51) << above;
    EXPECT_LE(told, 32 * Crowd::kUnseen + 0.01) << above;
  }
}

TEST(Crowd, OnlyWhatIsSeenIsDrawn) {
  SceneBuilder build({.box = {{0, 0}, {64, 64}}}, {0, 0, 0, 1});
  for (int i = 0; i < int(Crowd::kMany); ++i)
    build.layer("hidden", build.shape(Disc{{32.0, 32.0}, 1.0 + 0.001 * i}), {{1, 0, 0, 1}});
  build.layer("cover", build.shape(Disc{{32, 32}, 100}), {{0, 1, 0, 1}});
  RenderStats stats;
  const Image image =
      test::rendered(std::move(build).finish(), {.width = 64, .height = 64}, {}, &stats);
  EXPECT_EQ(image.row(32)[4 * 32], 0);
  EXPECT_EQ(image.row(32)[4 * 32 + 1], 255);
  EXPECT_EQ(stats.fill_pixels + stats.edge_pixels, 64 * 64);
  EXPECT_EQ(stats.crossings, 0);
}

}  // namespace
}  // namespace mien::test
