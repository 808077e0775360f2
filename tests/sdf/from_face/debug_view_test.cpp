#include "sdf/from_face/debug_view.h"

#include <mien/face_model.h>
#include <mien/scene_from_face.h>
#include <mien/text_path.h>
#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/faces.h"

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
