// Areas made of features: sets of points, asked at many places.

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

/// Discs a, b, c and what is said of one more feature, "x".
Scene scene_of_discs(const std::string& x) {
  const auto disc = [](const char* name, const char* center) {
    return std::string(R"({"name": ")") + name + R"(", "kind": "disc", "radius": 0.5, "center": )" +
           center + "}, ";
  };
  const Expected<Face> face = read_face_text(
      test::face_with(disc("a", "[-0.2, 0]") + disc("b", "[0.2, 0]") + disc("c", "[0, 0.3]") + x));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return scene_from_face(*face);
}

/// Whether the one layer of the scene is where `wanted` says, by the discs that a place is in.
template <class Wanted>
void expect_area(const std::string& x, Wanted wanted) {
  const Scene scene = scene_of_discs(x);
  ASSERT_EQ(scene.layers().size(), 1u) << x;
  for (double px = -0.95; px < 1; px += 0.1)
    for (double py = -0.95; py < 1; py += 0.1) {
      const auto in = [&](double cx, double cy) { return std::hypot(px - cx, py - cy) < 0.5; };
      EXPECT_EQ(scene.distance(scene.layers()[0].area, {px, py}) < 0,
                wanted(in(-0.2, 0), in(0.2, 0), in(0, 0.3)))
          << x << " at " << px << " " << py;
    }
}

TEST(FeatureAreas, AreMadeOfOthers) {
  const std::string area = R"({"name": "x", "kind": "area", "paint": "black", )";
  expect_area(area + R"("any": ["a", "b"]})", [](bool a, bool b, bool) { return a || b; });
  expect_area(area + R"("all": ["a", "b", "c"]})",
              [](bool a, bool b, bool c) { return a && b && c; });
  expect_area(area + R"("all": ["c"], "any": ["a", "b"]})",
              [](bool a, bool b, bool c) { return c && (a || b); });
  expect_area(area + R"("any": ["a", "c"], "minus": ["b"]})",
              [](bool a, bool b, bool c) { return (a || c) && !b; });
}

TEST(FeatureAreas, GrowAsAWholeBeforeTheyAreClipped) {
  const Scene scene = scene_of_discs(
      R"({"name": "x", "kind": "area", "paint": "black", "any": ["a", "b"], "grow": 0.2, "clip": {"outside": "c"}})");
  ASSERT_EQ(scene.layers().size(), 1u);
  for (double px = -0.95; px < 1; px += 0.1)
    for (double py = -0.95; py < 1; py += 0.1) {
      const bool in = std::min(std::hypot(px + 0.2, py), std::hypot(px - 0.2, py)) < 0.7,
                 out = std::hypot(px, py - 0.3) < 0.5;
      EXPECT_EQ(scene.distance(scene.layers()[0].area, {px, py}) < 0, in && !out)
          << px << " " << py;
    }
}

TEST(FeatureAreas, AreClippedByAllOfTheirClips) {
  const std::string large =
      R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0, 0], "radii": [2, 2], "corner": 0, "clip": )";
  expect_area(large + R"("a"})", [](bool a, bool, bool) { return a; });
  expect_area(large + R"({"outside": "b"}})", [](bool, bool b, bool) { return !b; });
  expect_area(large + R"(["a", {"outside": "b"}, "c"]})",
              [](bool a, bool b, bool c) { return a && !b && c; });
}

/// A feature of the outline that it is clipped to has that very area, and what clips it besides.
TEST(FeatureAreas, ShareTheOutlineTheyAreClippedTo) {
  const std::string same =
      R"({"name": "x", "kind": "disc", "paint": "black", "center": [-0.2, 0], "radius": 0.5, "clip": )";
  const Scene shared = scene_of_discs(same + R"("a"})");
  EXPECT_EQ(shared.shapes().size(), 3u);
  expect_area(same + R"([{"outside": "b"}, "a"]})", [](bool a, bool b, bool) { return a && !b; });
}

/// What holds of the rectangle and of the disc at each of its corners.
TEST(FeatureAreas, RoundedRectanglesHaveRoundCorners) {
  const Scene scene = scene_of_discs(
      R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0.1, 0.2], "radii": [0.6, 0.3], "corner": 0.1, "tilt": 90})");
  const Area area = scene.layers()[0].area;
  EXPECT_NEAR(scene.distance(area, {0.1 + 0.3, 0.2}), 0, 1e-15);
  EXPECT_NEAR(scene.distance(area, {0.1, 0.2 + 0.6}), 0, 1e-15);
  const glm::dvec2 corner{0.1 + 0.2, 0.2 + 0.5};  // the middle of the round corner
  EXPECT_NEAR(scene.distance(area, corner + 0.1 * glm::normalize(glm::dvec2{1, 2})), 0, 1e-15);
  EXPECT_NEAR(scene.distance(area, corner + 0.3 * glm::normalize(glm::dvec2{1, 1})), 0.2, 1e-15);
  for (const char* corner_text : {"0.3", "7"}) {  // both ends round
    const Scene round = scene_of_discs(
        std::string(
            R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0, 0], "radii": [0.6, 0.3], "corner": )") +
        corner_text + "}");
    EXPECT_NEAR(round.distance(round.layers()[0].area, {0.6, 0}), 0, 1e-15);
    EXPECT_NEAR(round.distance(round.layers()[0].area, {0.3 + 0.18, 0.24}), 0, 1e-15);
  }
  const Scene high = scene_of_discs(
      R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0, 0], "radii": [0.3, 0.6], "corner": 1})");
  EXPECT_NEAR(high.distance(high.layers()[0].area, {0.18, 0.3 + 0.24}), 0, 1e-15);
  EXPECT_NEAR(high.distance(high.layers()[0].area, {-0.3, -0.2}), 0, 1e-15);
  const Scene disc = scene_of_discs(
      R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0, 0], "radii": [0.3, 0.3], "corner": 1})");
  EXPECT_NEAR(disc.distance(disc.layers()[0].area, {0.18, 0.24}), 0, 1e-15);
}

TEST(FeatureAreas, RoundedRectanglesHaveFourSidesAndCornersAlike) {
  const Scene scene = scene_of_discs(
      R"({"name": "x", "kind": "rounded", "paint": "black", "center": [0.1, -0.2], "radii": [0.6, 0.3], "corner": 0.1})");
  const Area area = scene.layers()[0].area;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const auto distance = [&](double right, double up) {
        return scene.distance(area, {0.1 + x * right, -0.2 + y * up});
      };
      EXPECT_NEAR(distance(0.7, 0.1), 0.1, 1e-15) << x << y;   // beside
      EXPECT_NEAR(distance(0.3, 0.5), 0.2, 1e-15) << x << y;   // above or below
      EXPECT_NEAR(distance(0.8, 0.6), 0.4, 1e-15) << x << y;   // 3, 4, 5 from a corner's middle
      EXPECT_NEAR(distance(0.4, 0.2), -0.1, 1e-15) << x << y;  // within
    }
}

/// At each point the line is as wide as it says there, half-way between two points half-way.
TEST(FeatureAreas, PolylinesMayHaveAWidthAtEachPoint) {
  for (const std::string smooth : {R"(, "smooth": true)", ""}) {
    const Scene scene = scene_of_discs(
        R"({"name": "x", "kind": "polyline", "paint": "black", "points": [[-0.6, 0], [-0.6, 0], [0, 0], [0.6, 0]], "half_width": [0.05, 0.05, 0.1, 0])" +
        smooth + "}");
    const Area area = scene.layers()[0].area;
    EXPECT_NEAR(scene.distance(area, {-0.65, 0}), 0, 1e-12) << smooth;
    EXPECT_NEAR(scene.distance(area, {0, 0}), -0.1, 2e-3) << smooth;
    EXPECT_NEAR(scene.distance(area, {-0.3, 0}), -0.075, 2e-3) << smooth;
    EXPECT_NEAR(scene.distance(area, {0.3, 0}), -0.05, 2e-3) << smooth;
    EXPECT_NEAR(scene.distance(area, {0.6, 0}), 0, 1e-12) << smooth;
  }
  const Scene dot = scene_of_discs(
      R"({"name": "x", "kind": "polyline", "paint": "black", "points": [[0, 0], [0, 0]], "half_width": [0.1, 0.2]})");
  EXPECT_NEAR(dot.distance(dot.layers()[0].area, {0.3, 0}), 0.2, 1e-12);
}

}  // namespace
}  // namespace mien
