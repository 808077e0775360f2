#include <mien/render.h>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "sdf/scene/legible.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

Scene beads() {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  for (int i = 0; i < 12; ++i) {
    const double a = 0.5236 * i;
    build.layer("bead", build.shape(Disc{{0.7 * std::cos(a), 0.7 * std::sin(a)}, 0.25}),
                {{0.1 * (i % 4), 0.2, 0.7, 0.6}});
  }
  return std::move(build).finish();
}

TEST(Render, GivesAnImageOfTheSizeAndDepthAskedFor) {
  for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
    const Image image = test::rendered(beads(), {.width = 33, .height = 17}, {.depth = depth});
    EXPECT_EQ(image.width, 33);
    EXPECT_EQ(image.height, 17);
    EXPECT_EQ(image.bytes.size(), 33u * 17 * 4 * bytes_per_channel(depth));
    EXPECT_TRUE(image.opaque);
  }
  EXPECT_FALSE(
      test::rendered(beads(), {.width = 8, .height = 8, .background = Color{0, 0, 0, 0}}).opaque);
}

/// A picture's least width is in its own pixels, whatever part of it is drawn, also where layers are drawn by windows.
TEST(Render, DrawsLinesAtLeastAsWideAsAsked) {
  SceneBuilder build({.box = {{0, 0}, {10, 10}}}, {1, 1, 1, 1});
  for (int i = 0; i < 3; ++i)
    build.layer("line", build.shape(Line{{1, 2.0 + 3 * i}, {9, 2.0 + 3 * i}, 0.02}),
                {{0, 0, 0, 1}});
  const Scene scene = std::move(build).finish();
  View view{.width = 100, .height = 100, .legible = 1.2};
  const Image all = test::rendered(scene, view);
  EXPECT_EQ(all.bytes,
            test::rendered(legible_scene(scene, 0.12), {.width = 100, .height = 100}).bytes);
  view.region = PixelRect{20, 10, 30, 40};
  const Image part = test::rendered(scene, view);
  for (int y = 0; y < 40; ++y)
    EXPECT_EQ(std::memcmp(&part.bytes[std::size_t(y) * 120],
                          &all.bytes[std::size_t(y + 10) * 400 + 80], 120),
              0)
        << y;
}

TEST(Render, OfOnePixelIsTheMeanOfTheWholePicture) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 1});
  build.layer("quarter", build.shape(Triangle{{-1, -1}, {1, -1}, {0, 0}}), {{1, 1, 1, 1}});
  const Image image =
      test::rendered(std::move(build).finish(), {.width = 1, .height = 1}, {.depth = Depth::f32});
  float red;
  std::memcpy(&red, image.bytes.data(), 4);
  EXPECT_NEAR(red, 0.25, 1e-4);
}

TEST(Render, CountsWhatItDid) {
  RenderStats stats;
  test::rendered(beads(), {.width = 200, .height = 200}, {}, &stats);
  EXPECT_EQ(stats.pixels, 40000);
  EXPECT_EQ(stats.fill_pixels + stats.edge_pixels, 40000);
  EXPECT_GT(stats.fill_pixels, 20000);
  EXPECT_FALSE(stats.cancelled);
}

TEST(Render, TellsItsProgressAndStopsWhenAsked) {
  double last = 0;
  int calls = 0;
  test::rendered(beads(), {.width = 700, .height = 700},
                 {.threads = {.count = 2}, .progress = [&](double done) {
                    EXPECT_GE(done, last);
                    last = done;
                    ++calls;
                    return true;
                  }});
  EXPECT_EQ(last, 1);
  EXPECT_GT(calls, 4);
  RenderStats stats;
  const auto cancelled = render(beads(), {.width = 700, .height = 700},
                                {.progress = [](double) { return false; }}, &stats);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().what, "cancelled");
  EXPECT_TRUE(stats.cancelled);
}

TEST(Render, OfAPictureThatCannotBeSaysWhy) {
  constexpr int kSide = View::kMaxSide, kMost = std::numeric_limits<int>::max();
  for (const View& view :
       {View{.width = 0, .height = 9}, View{.width = 9, .height = -1},
        View{.width = kSide + 1, .height = 1}, View{.width = kMost, .height = kMost},
        View{.width = -5, .height = -5, .region = PixelRect{0, 0, 3, 3}}}) {
    const auto image = render(beads(), view, {.depth = Depth::f32});
    ASSERT_FALSE(image);
    EXPECT_TRUE(image.error().what.ends_with("sides are 1 ... 1048576")) << image.error().what;
    std::byte pixel[16];
    const auto done = render_into({pixel, 16, Depth::f32}, beads(), view);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().what, image.error().what);
  }
  if constexpr (!test::kSanitized) {  // whose own allocators end the program instead
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
    const rlimit scarce{rlim_t{1} << 36, before.rlim_max};  // else some systems promise anything
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &scarce), 0);
    const auto image =
        render(beads(), {.width = kSide, .height = kSide}, {.depth = Depth::f32});  // 16 TiB
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().what, "memory ran out: the picture has 1048576 x 1048576 pixels");
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
  }
}

TEST(RenderInto, TouchesOnlyThePixelsOfItsRows) {
  const View view{.width = 40, .height = 30, .region = PixelRect{5, 6, 20, 10}};
  const std::size_t stride = 20 * 4 + 12;
  std::vector<std::byte> mine(stride * 10 + 64, std::byte{0xA5});
  EXPECT_TRUE(render_into({mine.data(), stride, Depth::u8}, beads(), view));
  const Image whole = test::rendered(beads(), {.width = 40, .height = 30});
  for (std::size_t y = 0; y < 10; ++y) {
    EXPECT_EQ(std::memcmp(mine.data() + stride * y, whole.row(int(y) + 6) + 4 * 5, 80), 0);
    for (std::size_t i = 80; i < stride; ++i) ASSERT_EQ(mine[stride * y + i], std::byte{0xA5});
  }
}

}  // namespace
}  // namespace mien
