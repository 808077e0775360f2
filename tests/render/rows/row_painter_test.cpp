#include "render/rows/row_painter.h"

#include <gtest/gtest.h>

#include <mien/render.h>

#include <cstring>

#include "tests/support/pictures/rendered.h"

namespace mien {
namespace {

TEST(RowPainter, WritesRunsInExactlyTheLooksColour) {  // however many sums lie before them
  SceneBuilder build({.box = {{0, 0}, {600, 4}}, .y_up = false}, {0.2, 0.4, 0.6, 1});
  for (int i = 0; i < 150; ++i)
    build.layer("bar", build.shape(Line{{4.0 * i + 1.3, -9}, {4.0 * i + 1.7, 9}, 0.61}),
                {{0.003 * i, 0.9 - 0.004 * i, 0.5, 1}});
  const Scene scene = std::move(build).finish();
  for (const Depth depth : {Depth::u8, Depth::u16}) {
    const View view{.width = 600, .height = 4};
    const Image image = test::rendered(scene, view, {.depth = depth});
    std::byte want[8];
    store(mix_from_color({0.2, 0.4, 0.6, 1}, Blend::linear), Blend::linear, depth, want);
    for (int i = 0; i < 149; ++i)  // 3.5 is well between two bars
      for (int y = 0; y < 4; ++y)
        ASSERT_EQ(std::memcmp(image.row(y) + (4 * i + 3) * 4 * int(bytes_per_channel(depth)), want,
                              4 * bytes_per_channel(depth)),
                  0)
            << i << ' ' << y;
  }
}

TEST(RowPainter, DithersWhatVariesAndNothingElse) {
  SceneBuilder build({.box = {{0, 0}, {64, 16}}, .y_up = false}, {0.2, 0.4, 0.6, 1});
  build.layer(
      "ramp", build.shape(HalfPlane{{1, 0}, 32.5}),
      {.color = {0, 0, 0, 1},
       .gradient = shared(Gradient{LinearGradient{{0, 0}, {64, 0}},
                                   {{0, {0.2, 0.2, 0.2, 1}}, {1, {0.21, 0.21, 0.21, 1}}}})});
  const Scene scene = std::move(build).finish();
  View view{.width = 64, .height = 16};
  const Image dithered = test::rendered(scene, view);
  view.dither = false;
  const Image plain = test::rendered(scene, view);
  long differ = 0;
  for (int y = 0; y < 16; ++y) {
    EXPECT_EQ(std::memcmp(dithered.row(y) + 4 * 33, plain.row(y) + 4 * 33, 4 * 31), 0);
    for (int i = 0; i < 4 * 32; ++i) differ += dithered.row(y)[i] != plain.row(y)[i];
  }
  EXPECT_GT(differ, 50);
}

/// Outlines that cross the first column, over stripes, whose parts need their forms: rows do not know each other.
TEST(RowPainter, BeginsEveryRowAnew) {
  SceneBuilder build({.box = {{0, 0}, {40, 16}}, .y_up = false}, {1, 1, 1, 1});
  std::vector<Stop> stops;
  for (int i = 0; i <= 160; ++i) stops.push_back({i / 160.0, {i % 2 * 1.0, 0.5, 0.2, 1}});
  build.layer("stripes", build.everywhere(),
              {.color = {0, 0, 0, 1},
               .gradient = shared(Gradient{LinearGradient{{0, 0}, {40, 9}}, stops})});
  build.layer("slope", build.shape(HalfPlane{glm::normalize(glm::dvec2{-1, 0.05}), 0.0}),
              {{0.1, 0.2, 0.3, 1}});
  build.layer("disc", build.shape(Disc{{20, 8}, 6}), {{0.1, 0.2, 0.3, 1}});
  const Scene scene = std::move(build).finish();
  const View view{.width = 40, .height = 16, .dither = false};
  const Image whole = test::rendered(scene, view);
  for (int y = 0; y < 16; ++y) {
    View row = view;
    row.region = PixelRect{0, y, 40, 1};
    EXPECT_EQ(std::memcmp(test::rendered(scene, row).row(0), whole.row(y), 4 * 40), 0) << y;
  }
}

}  // namespace
}  // namespace mien
