#include "sdf/scene/legible.h"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

namespace mien {
namespace {

constexpr double kLeast = 1;

Scene scene_of(const Shape& shape) {
  SceneBuilder build({.box = {{-9, -9}, {9, 9}}}, {1, 1, 1, 1});
  build.layer("it", build.shape(shape), {{0, 0, 0, 0.5}});
  return std::move(build).finish();
}

double opacity_of(const Scene& scene) {
  return scene.layers()[0].paint.color.a;
}

double width_of(const Scene& scene) {
  const Line& line = std::get<Line>(scene.shapes()[0]);
  return 2 * line.half_width;
}

TEST(Legible, WidensLinesUpToThreeTimesAndFadesTheRest) {
  struct Case {
    double width, seen_width, opacity;
  };
  for (const Case& c :
       {Case{2, 2, 0.5}, {1, 1, 0.5}, {0.5, 1, 0.5}, {0.2, 0.6, 0.3}, {0.1, 0.3, 0.15}}) {
    const Scene made = legible_scene(scene_of(Line{{0, 0}, {5, 0}, 0.5 * c.width}), kLeast);
    EXPECT_NEAR(width_of(made), c.seen_width, 1e-12) << c.width;
    EXPECT_NEAR(opacity_of(made), c.opacity, 1e-12) << c.width;
  }
}

TEST(Legible, KeepsTheFormOfATaperedStroke) {
  // Its middle is 0.25 wide: half of the middle number and a quarter of the ends'.
  const Scene made =
      legible_scene(scene_of(TaperedStroke{{{0, 0}, {1, 1}, {2, 0}}, {0, 0.25, 0}}), kLeast);
  const auto& stroke = std::get<TaperedStroke>(made.shapes()[0]);
  EXPECT_EQ(stroke.half_width[0], 0);
  EXPECT_NEAR(stroke.half_width[1], 0.75, 1e-12);
  EXPECT_EQ(stroke.half_width[2], 0);
  EXPECT_NEAR(opacity_of(made), 0.5 * 0.75, 1e-12);
}

TEST(Legible, WidensRibbonsAlongOutlines) {
  SceneBuilder build({.box = {{-9, -9}, {9, 9}}}, {1, 1, 1, 1});
  build.layer("it", build.shell(build.shape(Disc{{0, 0}, 5}), 0.2), {{0, 0, 0, 0.5}});
  const Scene scene = std::move(build).finish();
  EXPECT_NEAR(legible_scene(scene, kLeast).nodes()[1].amount, 0.5, 1e-12);
  EXPECT_NEAR(legible_scene(scene, 3).nodes()[1].amount, 0.6, 1e-12);
  EXPECT_NEAR(opacity_of(legible_scene(scene, 3)), 0.5 * 0.4, 1e-12);
}

TEST(Legible, FadesWhatHasHardlyAnArea) {
  EXPECT_EQ(opacity_of(legible_scene(scene_of(Disc{{0, 0}, 0.5}), kLeast)), 0.5);
  EXPECT_NEAR(opacity_of(legible_scene(scene_of(Disc{{0, 0}, 0.25}), kLeast)), 0.125, 1e-12);
  EXPECT_EQ(opacity_of(legible_scene(scene_of(HalfPlane{{1, 0}, 0}), kLeast)), 0.5);
}

TEST(Legible, OfCombinedAreasAsksWhatIsLeft) {
  const auto seen = [](auto combine) {
    SceneBuilder build({.box = {{-9, -9}, {9, 9}}}, {1, 1, 1, 1});
    const Area small = build.shape(Disc{{0, 0}, 0.25}), large = build.shape(Disc{{0, 0}, 3});
    build.layer("it", combine(build, small, large), {{0, 0, 0, 1}});
    return opacity_of(legible_scene(std::move(build).finish(), kLeast));
  };
  EXPECT_EQ(seen([](SceneBuilder& b, Area s, Area l) { return b.unite(s, l); }), 1);
  EXPECT_NEAR(seen([](SceneBuilder& b, Area s, Area l) { return b.intersect(s, l); }), 0.25, 1e-12);
  EXPECT_EQ(seen([](SceneBuilder& b, Area s, Area l) { return b.subtract(l, s); }), 1);
  EXPECT_EQ(seen([](SceneBuilder& b, Area s, Area) { return b.complement(s); }), 1);
  EXPECT_EQ(seen([](SceneBuilder& b, Area, Area) { return b.everywhere(); }), 1);
}

/// Ink per length on screen, the line's width in pixels times its opacity, and each of both, never grow.
TEST(Legible, IsMonotoneInThePicturesSize) {
  double width_before = 0, opacity_before = 0;
  for (double scale = 0.5; scale < 40; scale *= 1.05) {  // [px] of a face unit
    const Scene made = legible_scene(scene_of(Line{{0, 0}, {5, 0}, 0.1}), 1.5 / scale);
    const double width = width_of(made) * scale, opacity = opacity_of(made);
    EXPECT_GE(width, width_before * (1 - 1e-12));
    EXPECT_GE(opacity, opacity_before * (1 - 1e-12));
    width_before = width, opacity_before = opacity;
  }
}

TEST(Legible, LeavesAllAsItIsWithoutALeast) {
  const Scene scene = scene_of(Line{{0, 0}, {5, 0}, 1e-9});
  EXPECT_EQ(legible_scene(scene, 0).text(), scene.text());
  EXPECT_EQ(legible_scene(scene, -1).text(), scene.text());
}

}  // namespace
}  // namespace mien
