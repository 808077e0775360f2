// The first promise: no channel of any pixel is off by more than 1 of 255 from the exact picture.

#include <mien/mien.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <random>

#include "tests/support/effort.h"
#include "tests/support/faces.h"
#include "tests/support/random_plain_scene.h"
#include "tests/support/rendered.h"
#include "tests/support/truth.h"

namespace mien {
namespace {

using test::face_named;

Image drawn(const Face& face, const std::vector<std::string>& settings, int width, int height) {
  return test::rendered(scene_from_face(test::posed(face, settings)),
                        {.width = width, .height = height, .blend = Blend::srgb});
}

std::vector<std::string> eyes(glm::dvec2 gaze, double dilation, double blink) {
  return {fmt::format("gaze.x={}", gaze.x), fmt::format("gaze.y={}", gaze.y),
          fmt::format("dilation={}", dilation), fmt::format("blink={}", blink)};
}

void expect_exact(const Image& image, const test::TruthScene& truth, int grid, int every = 1) {
  const test::TruthError error =
      test::compare_with_truth(image, truth, grid, every * test::kThinning);
  EXPECT_EQ(error.over_one, 0) << error.where;
  EXPECT_GT(error.edge_pixels, 0);
  testing::Test::RecordProperty(
      "worst", fmt::format("{} of 255 over {} edge pixels", error.worst, error.edge_pixels));
}

TEST(Exact, EyesLookingUpRight) {  // E1 – E7, E12
  const Face face = face_named("seed0");
  expect_exact(drawn(face, eyes({0.03, -0.02}, 1, 0), 640, 360),
               test::eyes_truth(640, 360, {0.03, -0.02}, 1, 0), 256);
}

TEST(Exact, EyesWithThePupilCutByTheLowerLid) {  // E4
  const Face face = face_named("seed0");
  expect_exact(drawn(face, eyes({0.05, -0.09}, 1, 0), 640, 360),
               test::eyes_truth(640, 360, {0.05, -0.09}, 1, 0), 256);
}

TEST(Exact, TheMuscleFaceAtRest) {  // M1 – M3
  expect_exact(drawn(face_named("male"), {}, 512, 512), test::male_truth(512), 256);
}

TEST(Exact, AHundredRandomPosesAtRandomSizes) {
  const Face face = face_named("seed0");
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < (test::kSanitized ? 20 : 100); ++i) {
    const int width = 24 + int(unit(random) * 400), height = 16 + int(unit(random) * 240);
    const glm::dvec2 gaze{0.16 * unit(random) - 0.08, 0.14 * unit(random) - 0.07};
    const double dilation = 0.7 + 0.5 * unit(random), blink = unit(random);
    SCOPED_TRACE(fmt::format("pose {}: {}x{} gaze {} {} dilation {} blink {}", i, width, height,
                             gaze.x, gaze.y, dilation, blink));
    expect_exact(drawn(face, eyes(gaze, dilation, blink), width, height),
                 test::eyes_truth(width, height, gaze, dilation, blink), 128, 4);
  }
}

TEST(Exact, TheNativeFace) {
  for (const auto& [width, height] : {std::pair{64, 36}, {320, 180}}) {
    const Scene scene = scene_from_face(test::posed(  // flat: this truth knows no light
        face_named("toon"),
        {"blink=0.3", "gaze.x=0.01", "eyeball.left/dome/height=0", "eyeball.right/dome/height=0"}));
    expect_exact(test::rendered(scene, {.width = width, .height = height, .blend = Blend::srgb}),
                 test::scene_truth(scene, width, height), 128);
  }
}

TEST(Exact, RandomScenesOfEveryShapeAndOperator) {
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 30 : 150); ++seed) {
    const int side = seed % 3 == 0 ? 11 : seed % 3 == 1 ? 24 : 40;
    const Scene scene = test::random_plain_scene(seed);
    SCOPED_TRACE(fmt::format("seed {} at {} px:\n{}", seed, side, scene.text()));
    const Image image =
        test::rendered(scene, {.width = side, .height = side, .blend = Blend::srgb});
    const test::TruthError error =
        test::compare_with_truth(image, test::scene_truth(scene, side, side), 256, test::kThinning);
    EXPECT_EQ(error.over_one, 0) << error.where;
  }
}

}  // namespace
}  // namespace mien
