#include <mien/render/rows/drawing.h>

#include <gtest/gtest.h>

#include <mien/render/render.h>

#include <cstring>

#include "tests/support/random_scene.h"

namespace mien {
namespace {

TEST(Drawing, OfAPartIsThatPartOfTheWhole) {
  for (int seed = 1; seed <= 2; ++seed) {
    const Scene scene = test::random_painted_scene(std::uint64_t(seed));
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
      View view{.width = 71, .height = 53};
      const Image whole = render(scene, view, {.depth = depth});
      const std::size_t pixel = 4 * bytes_per_channel(depth);
      for (const PixelRect part :
           {PixelRect{0, 0, 1, 1}, {70, 52, 1, 1}, {13, 15, 40, 3}, {64, 0, 7, 53}}) {
        view.region = part;
        const Image piece = render(scene, view, {.depth = depth});
        for (int y = 0; y < part.height; ++y)
          ASSERT_EQ(std::memcmp(piece.row(y), whole.row(y + part.y) + pixel * std::size_t(part.x),
                                pixel * std::size_t(part.width)),
                    0)
              << "seed " << seed << " row " << y;
      }
    }
  }
}

TEST(Drawing, OfAnySizeIsFilledToItsBorders) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 0, 0, 1});
  const Scene scene = std::move(build).finish();
  for (const int width : {1, 63, 64, 65})
    for (int height = 1; height <= 17; ++height) {
      const Image image = render(scene, {.width = width, .height = height});
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(image.row(y)[4 * x], 255);
    }
}

TEST(Drawing, CountsWhatItDid) {
  SceneBuilder build({.box = {{0, 0}, {100, 100}}}, {0, 0, 0, 1});
  build.layer("disc", build.shape(Disc{{50, 50}, 30}), {{1, 1, 1, 1}});
  RenderStats stats;
  render(std::move(build).finish(), {.width = 100, .height = 100}, {}, &stats);
  EXPECT_EQ(stats.fill_pixels + stats.edge_pixels, 10'000);
  EXPECT_EQ(stats.regions, 2);
  EXPECT_EQ(stats.doubts, 0);
  EXPECT_GT(stats.roots, 190);
}

}  // namespace
}  // namespace mien
