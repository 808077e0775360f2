// What is drawn over, under and along features: feathers, shadows on one of them, contours that vary.

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

/// A disc of radius 0.5 with what is said of it, on a wall on the left.
Scene scene_of_disc(const std::string& more, const std::string& rest = "") {
  const Expected<Face> face = read_face_text(test::face_with(
      R"({"name": "wall", "kind": "rounded", "paint": "skin", "center": [-0.5, 0], "radii": [0.5, 1], "corner": 0},
         {"name": "x", "kind": "disc", "paint": "black", "center": [0, 0], "radius": 0.5, )" +
          more + "}",
      rest));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return scene_from_face(*face);
}

const Layer& layer_named(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.layers(), name, &Layer::name);
  if (found == scene.layers().end()) throw std::runtime_error("no layer " + std::string(name));
  return *found;
}

TEST(FeaturePaint, AFeatherRisesFromTheOutlineInwards) {
  const Scene scene = scene_of_disc(R"("feather": 0.2, "opacity": 0.6)");
  const Layer& x = layer_named(scene, "x");
  EXPECT_EQ(x.paint.color.a, 0.6);
  ASSERT_TRUE(x.paint.gradient);
  const auto& along = std::get<DistanceGradient>(x.paint.gradient->along);
  EXPECT_EQ(along.from, -0.2);
  EXPECT_EQ(along.to, 0);
  EXPECT_EQ(scene.distance(along.area, {0.5, 0}), 0);
  EXPECT_EQ(x.paint.gradient->stops.front().color, (Color{0, 0, 0, 1}));
  EXPECT_EQ(x.paint.gradient->stops[8].color.a, 0.5);
  EXPECT_EQ(x.paint.gradient->stops.back().color.a, 0);
  EXPECT_FALSE(layer_named(scene_of_disc(R"("feather": 0)"), "x").paint.gradient);
}

/// A pose may add up to more than all of it.
TEST(FeaturePaint, NothingIsMoreThanOpaque) {
  Expected<Face> face = read_face_text(test::face_with(
      R"({"name": "x", "kind": "disc", "paint": "black", "center": [0, 0], "radius": 0.5, "opacity": 0.5})"));
  ASSERT_TRUE(face);
  const Layout& layout = face->model->layout;
  double& opacity = face->vector[std::size_t(layout[layout.find("x/opacity")].begin)];
  EXPECT_EQ(layer_named(scene_from_face(*face), "x").paint.color.a, 0.5);
  opacity = 1.5;
  EXPECT_EQ(layer_named(scene_from_face(*face), "x").paint.color.a, 1);
}

TEST(FeaturePaint, AShadowFallsOnTheFeatureThatItIsOn) {
  const std::string shadow = R"("shadow": {"color": "black", "blur": 0.1)";
  const Scene on = scene_of_disc(shadow + R"(, "on": "wall"})"), all = scene_of_disc(shadow + "}");
  const Area wall = layer_named(on, "x/shadow").area,
             everywhere = layer_named(all, "x/shadow").area;
  EXPECT_LT(on.distance(wall, {-0.3, 0.3}), 0);
  EXPECT_GT(on.distance(wall, {0.3, 0.3}), 0);
  EXPECT_LT(all.distance(everywhere, {0.3, 0.3}), 0);
}

/// The lamp stands to the left and above: the line is thick on the right and below.
TEST(FeaturePaint, APenContourIsThickAwayFromTheLamp) {
  const std::string lamp = R"(, "light": {"direction": [-0.6, 0.8, 1]})";
  const Scene scene = scene_of_disc(
      R"("contour": {"color": "black", "widths": [0.01, 0.03], "by": "angle"})", lamp);
  const Area line = layer_named(scene, "x/contour").area;
  const glm::dvec2 away{0.6, -0.8};
  EXPECT_LT(scene.distance(line, 0.455 * away), 0);
  EXPECT_GT(scene.distance(line, 0.445 * away), 0);
  EXPECT_LT(scene.distance(line, -0.492 * away), 0);
  EXPECT_GT(scene.distance(line, -0.488 * away), 0);
}

TEST(FeaturePaint, ABrushContourStaysWhereItsClipsLetIt) {
  const Scene scene = scene_of_disc(
      R"("clip": "wall", "contour": {"color": "black", "widths": [0, 0.05], "by": "along"})");
  const Area line = layer_named(scene, "x/contour").area;
  EXPECT_LT(scene.distance(line, {-0.54, 0}), 0);  // half-way round
  EXPECT_GT(scene.distance(line, {0.5, 0}), 0);    // where it begins, and beyond the wall
  EXPECT_GT(scene.distance(line, {0.1, 0.49}), 0);
}

}  // namespace
}  // namespace mien
