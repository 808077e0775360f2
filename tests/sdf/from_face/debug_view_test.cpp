#include "sdf/from_face/debug_view.h"

#include <mien/face_model.h>
#include <mien/scene_from_face.h>
#include <mien/text_path.h>
#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

int count(const Scene& scene, std::string_view name) {
  return int(std::count_if(scene.layers().begin(), scene.layers().end(),
                           [&](const Layer& layer) { return layer.name == name; }));
}

TEST(DebugView, ColoursGoFromBlueOverGreenToRed) {  // M11
  const auto expect = [](double pull, double r, double g, double b) {
    const Color c = pull_color(pull);
    EXPECT_NEAR(srgb_from_linear(c.r), r, 1e-12) << pull;
    EXPECT_NEAR(srgb_from_linear(c.g), g, 1e-12) << pull;
    EXPECT_NEAR(srgb_from_linear(c.b), b, 1e-12) << pull;
  };
  expect(0, 0, 0, 1);     // hue 240°
  expect(0.25, 0, 1, 1);  // 180°
  expect(0.5, 0, 1, 0);   // 120°
  expect(0.75, 1, 1, 0);  // 60°
  expect(1, 1, 0, 0);     // 0°
}

TEST(DebugView, DrawsEveryMuscleAndItsValue) {  // M11
  const Face face = test::face_named("male");
  std::vector<double> pulls(face.model->muscles.muscles.size());
  pulls[0] = 1;
  const Scene scene = debug_muscles(face, pulls, shipped_lettering());
  for (const Muscle& muscle : face.model->muscles.muscles)
    EXPECT_EQ(count(scene, control_of_side("muscle." + std::string(muscle.name), muscle.side)), 1);
  EXPECT_EQ(count(scene, "value"), 13);
  EXPECT_EQ(count(scene, "inner-occipitofrontalis"), 1);
  EXPECT_EQ(count(scene, "left"), 1);
  EXPECT_EQ(count(scene, "right"), 1);
  EXPECT_EQ(count(scene, "1.00"), 1) << "of the left one";
  EXPECT_EQ(count(scene, "0.00"), 25);
  for (const Layer& layer : scene.layers())
    if (layer.name == "muscle.left.inner-occipitofrontalis") {
      EXPECT_LT(scene.distance(layer.area, {50, -590}), 0);
      EXPECT_LT(scene.distance(layer.area, {40, -34}), 0);
    }
}

/// A place in a layer, by a lattice over the canvas.
glm::dvec2 place_in(const Scene& scene, std::string_view name) {
  const Box2& box = scene.canvas().box;
  constexpr int kSteps = 250;
  for (const Layer& layer : scene.layers())
    for (int i = 0; layer.name == name && i < kSteps * kSteps; ++i) {
      const glm::dvec2 p =
          box.lo + glm::dvec2{i % kSteps + 0.5, i / kSteps + 0.5} / double(kSteps) * box.size();
      if (scene.distance(layer.area, p) < 0) return p;
    }
  throw std::runtime_error("nothing of " + std::string(name));
}

TEST(DebugView, TheLegendStandsOnItsPlate) {
  for (const char* name : {"male", "bruno"}) {
    const Face face = test::face_named(name);
    const std::vector<double> pulls(face.model->muscles.muscles.size());
    const Scene scene = debug_muscles(face, pulls, shipped_lettering());
    const auto plate = std::ranges::find(scene.layers(), "plate", &Layer::name);
    ASSERT_NE(plate, scene.layers().end()) << name;
    const auto distance = [&](glm::dvec2 p) { return scene.distance(plate->area, p); };
    const glm::dvec2 left = place_in(scene, "left"), right = place_in(scene, "right"),
                     first = place_in(scene, "scale"), size = scene.canvas().box.size();
    EXPECT_LT(distance(left), 0) << name;
    EXPECT_LT(distance(right), 0) << name;
    EXPECT_LT(left.x - first.x, 0.45 * size.x) << name;  // columns follow the names closely
    EXPECT_GT(right.x, left.x) << name;
    // Its lower edge lies below the last line, and its distance is one.
    const double down = scene.canvas().y_up ? -1.0 : 1.0, far = 0.9 * size.y;
    const double edge = distance(left + glm::dvec2{0, down * far});
    EXPECT_GT(edge, 0) << name;
    EXPECT_NEAR(edge - distance(left + glm::dvec2{0, down * (far - 1)}), 1, 1e-9) << name;
  }
}

TEST(DebugView, NamesEveryPoint) {
  const Face face = test::face_named("bruno");
  const Scene scene = debug_points(face, shipped_lettering());
  int points = 0;
  for (const Slice& slice : face.model->layout.slices()) {
    if (slice.kind != SliceKind::point) continue;
    ++points;
    EXPECT_EQ(count(scene, slice.name), 1) << slice.name;
  }
  EXPECT_EQ(count(scene, "point"), points);
  EXPECT_GT(count(scene, "arm"), 20);
}

}  // namespace
}  // namespace mien
