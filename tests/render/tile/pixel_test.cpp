#include <mien/render/tile/pixel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mien {
namespace {

/// Coverage of the pixel around the origin by an area: black on white in light, so 1 − red.
double covered(SceneBuilder build, Area area, RenderStats& stats) {
  build.layer("area", area, {{0, 0, 0, 1}});
  const Tape tape = tape_from_scene(std::move(build).finish(), {.width = 4, .height = 4});
  ScopeStack scopes(tape);
  PixelResolver pixels(tape, scopes, stats);
  return 1 - pixels.pixel(scopes.everything(), {0, 0}).r;
}

SceneBuilder pixels_as_units() {
  return SceneBuilder({.box = {{-2, -2}, {2, 2}}, .y_up = false}, {1, 1, 1, 1});
}

double covered_by(const Shape& shape) {
  SceneBuilder build = pixels_as_units();
  const Area area = build.shape(shape);
  RenderStats stats;
  return covered(build, area, stats);
}

constexpr double kPi = std::numbers::pi;
constexpr double kQuarterLevel = 0.25 / 255;

TEST(PixelResolver, KnowsTheAreaOfShapesSmallerThanAPixel) {
  EXPECT_NEAR(covered_by(Disc{{0.1, 0.05}, 0.3}), 0.09 * kPi, kQuarterLevel);
  EXPECT_NEAR(covered_by(Ellipse{{0, 0}, {0.4, 0.1}, {0.6, 0.8}}), 0.04 * kPi, kQuarterLevel);
  EXPECT_NEAR(covered_by(Triangle{{-0.3, -0.3}, {0.4, 0}, {0, 0.4}}), 0.5 * (0.7 * 0.7 - 0.3 * 0.3),
              kQuarterLevel);
  EXPECT_NEAR(covered_by(Line{{-0.2, 0}, {0.2, 0}, 0.1}), 0.08 + 0.01 * kPi, kQuarterLevel);
  EXPECT_NEAR(covered_by(QuadStroke{{{-0.2, 0}, {0, 0}, {0.2, 0}}, 0.1}), 0.08 + 0.01 * kPi,
              kQuarterLevel);
  EXPECT_NEAR(covered_by(TaperedStroke{{{-0.2, 0}, {0, 0}, {0.2, 0}}, {0.1, 0.1, 0.1}}),
              0.08 + 0.01 * kPi, kQuarterLevel);
  const Path lens{{{{{{-0.3, 0}, {0, 0.3}, {0.3, 0}}, {{0.3, 0}, {0, -0.3}, {-0.3, 0}}}}}};
  EXPECT_NEAR(covered_by(lens), 0.12, kQuarterLevel);  // two parabola segments of 2/3 · 0.6 · 0.15
}

TEST(PixelResolver, KnowsStrokesThinnerThanAPixel) {
  for (const double half : {0.2, 0.02, 0.001}) {
    EXPECT_NEAR(covered_by(Line{{-9, 0.1}, {9, 0.1}, half}), 2 * half, 1e-12);
    EXPECT_NEAR(covered_by(QuadStroke{{{-40, 0.1}, {0, 0.1}, {40, 0.1}}, half}), 2 * half, 1e-4);
    EXPECT_NEAR(covered_by(TaperedStroke{{{-40, 0.1}, {0, 0.1}, {40, 0.1}}, {half, half, half}}),
                2 * half, 1e-4);
    EXPECT_NEAR(covered_by(Ellipse{{0, 0.1}, {300, half}}), 2 * half, 1e-4);
  }
}

TEST(PixelResolver, LeavesNoSeamInAUnionOfAbuttingShapes) {
  for (double angle = 0; angle < 3.1; angle += 0.37) {
    const glm::dvec2 n{std::cos(angle), std::sin(angle)};
    SceneBuilder build = pixels_as_units();
    const Area area =
        build.either(build.shape(HalfPlane{n, 0.1}), build.shape(HalfPlane{-n, -0.1}));
    RenderStats stats;
    EXPECT_NEAR(covered(build, area, stats), 1, 1e-12);
  }
}

TEST(PixelResolver, TakesTheClosedFormWhereOneEdgeIsProven) {
  SceneBuilder build = pixels_as_units();
  RenderStats stats;
  const double got = covered(build, build.shape(Disc{{0.2, -99.9}, 100}), stats);
  EXPECT_EQ(stats.one_edge_pixels, 1);
  EXPECT_EQ(stats.cells, 0);
  double expected = 0;  // the circle y = −99.9 + sqrt(100² − (x − 0.2)²) over the pixel
  for (int i = 0; i < 10000; ++i) {
    const double x = (i + 0.5) / 10000 - 0.7;
    expected += (-99.9 + std::sqrt(1e4 - x * x) + 0.5) / 10000;
  }
  EXPECT_NEAR(got, expected, 1e-7);
}

TEST(PixelResolver, DividesNoMoreThanItsDepth) {
  SceneBuilder build = pixels_as_units();
  Area all = build.shape(Disc{{0, 0}, 0.01});
  for (int i = 1; i < 60; ++i)  // more outlines in one pixel than an arrangement takes
    all = build.either(all, build.shape(Disc{{0.3 * std::cos(i), 0.3 * std::sin(i)}, 0.2}));
  RenderStats stats;
  const double got = covered(build, all, stats);
  EXPECT_GT(got, kPi * 0.23);
  EXPECT_LE(stats.cells, (1 << (2 * fineness(Depth::u8, Blend::srgb).depth + 1)));
}

}  // namespace
}  // namespace mien
