// The exact truth of lit surfaces, proven by closed forms of its own: what it then says of faces and
// random scenes is believed.

#include <mien/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>
#include <utility>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/faces/faces.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_lit_scene.h"

namespace mien {
namespace {

using std::numbers::pi;
using test::ExactTruth;
using test::Mixes;

const Light kLight{.direction = {-0.3, 0.5, 0.8}, .ambient = 0.4};

/// One pixel: the face from (0, 0) to (1, 1), y up, over black.
SceneBuilder one_pixel() {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {0, 0, 0, 1});
  build.light(kLight);
  return build;
}

Mixes mean_of(SceneBuilder build, double tolerance = 1e-7) {
  const Scene scene = std::move(build).finish();
  return ExactTruth(scene, {.width = 1, .height = 1}, tolerance).means(0, 0);
}

/// How bright a surface is that falls by `slope` towards `way`, of 1.
double brightness(double slope, glm::dvec2 way) {
  const glm::dvec3 l = kLight.direction;
  const double towards = (slope * (way.x * l.x + way.y * l.y) + l.z) / std::hypot(slope, 1);
  return kLight.ambient + (1 - kLight.ambient) * std::max(0.0, towards) / l.z;
}

Relief bevel(Area area, double width, double height) {
  return {.area = area, .profile = Profile::bevel, .width = width, .height = height};
}

TEST(ExactLight, ABevelAlongAStraightOutlineHasOneColour) {
  for (const double angle : {0.0, 0.7, 1.5707963267948966, 2.9, 4.0, 5.5}) {
    const glm::dvec2 way{std::cos(angle), std::sin(angle)};
    SceneBuilder build = one_pixel();
    const Area all = build.shape(HalfPlane{way, 3});
    build.layer("slope", all, {{0.5, 0.25, 0.1, 1}, {}, shared(bevel(all, 9, 6))});
    const double bright = brightness(6.0 / 9, way);
    const Mixes mean = mean_of(std::move(build));
    EXPECT_NEAR(mean.linear.r, 0.5 * bright, 1e-7) << angle;
    EXPECT_NEAR(mean.srgb.g, test::encoded(0.25 * bright), 1e-7) << angle;
    EXPECT_NEAR(mean.linear.a, 1, 1e-12);
  }
}

TEST(ExactLight, ABevelEndsAtItsWidthAndAtItsOutline) {
  SceneBuilder build = one_pixel();
  const Area half = build.shape(HalfPlane{{0.6, 0.8}, 0.9});
  build.layer("slope", half, {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(half, 0.2, 0.1))});
  const double outside = 0.5 * 0.5 * 0.5 / (0.6 * 0.8);        // a triangle at (1, 1)
  const double level = 0.5 * (0.7 / 0.8 + (0.7 - 0.6) / 0.8);  // a trapezium below the band
  EXPECT_NEAR(mean_of(std::move(build)).linear.r,
              0.5 * ((1 - outside - level) * brightness(0.5, {0.6, 0.8}) + level), 1e-6);
}

TEST(ExactLight, ARoundProfileAlongAStraightOutlineIntegrates) {
  // Of height = width, with u the share of the width to its end: n·l = l.z sqrt(1 − u²) + u l.way,
  // whose mean over u from 0 to 1 is l.z π/4 + l.way/2.
  for (const glm::dvec2 way : {glm::dvec2{-1, 0}, {0, 1}, {-0.6, 0.8}}) {
    SceneBuilder build({.box = {{-2, -2}, {2, 2}}}, {0, 0, 0, 1});
    build.light(kLight);
    const Area half = build.shape(HalfPlane{way, 0});
    const Area strip = build.intersect(build.intersect(half, build.shape(HalfPlane{-way, 0.9})),
                                       build.shape(Disc{{0, 0}, 1.5}));
    const Area square =
        build.intersect(strip, build.intersect(build.shape(HalfPlane{{way.y, -way.x}, 0.5}),
                                               build.shape(HalfPlane{{-way.y, way.x}, 0.5})));
    build.layer(
        "round", square,
        {{0.4, 0.4, 0.4, 1},
         {},
         shared(Relief{.area = half, .profile = Profile::round, .width = 0.9, .height = 0.9})});
    const Scene scene = std::move(build).finish();
    const ExactTruth truth(scene, {.width = 4, .height = 4}, 1e-7);
    double sum = 0;
    for (int i = 0; i < 16; ++i) sum += truth.means(i % 4, i / 4).linear.r;
    const glm::dvec3 l = kLight.direction;
    const double toward = pi / 4 + 0.5 * (way.x * l.x + way.y * l.y) / l.z;
    EXPECT_NEAR(sum, 0.4 * 0.9 * (kLight.ambient + (1 - kLight.ambient) * toward), 1e-6);
  }
}

/// The integral of f from a to b, f smooth.
double integral(const std::function<double(double)>& f, double a, double b) {
  constexpr int kSteps = 4000;
  double sum = f(a) + f(b);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 ? 4 : 2) * f(a + (b - a) * i / kSteps);
  return sum * (b - a) / (3 * kSteps);
}

double sum_of(const Scene& scene, int side, double tolerance) {  // [pixels]
  const ExactTruth truth(scene, {.width = side, .height = side}, tolerance);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) sum += truth.means(i % side, i / side).linear.r;
  return sum;
}

TEST(ExactLight, ABevelRoundADisc) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 1});
  build.light(kLight);
  const Area disc = build.shape(Disc{{0.0123, -0.0456}, 0.8});
  build.layer("disc", disc, {{0.6, 0.6, 0.6, 1}, {}, shared(bevel(disc, 0.25, 0.1))});
  const double round = integral(
      [](double t) {
        return brightness(0.4, {std::cos(t), std::sin(t)});
      },
      0, 2 * pi);
  const double want = 0.6 * (round * 0.5 * (0.8 * 0.8 - 0.55 * 0.55) + pi * 0.55 * 0.55);
  EXPECT_NEAR(sum_of(std::move(build).finish(), 6, 1e-6) * 4 / 36, want, 2e-6);
}

TEST(ExactLight, ADomeAlone) {  // what light from the side adds on one side it takes on the other
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0, 0, 0, 1});
  build.light(kLight);
  const Dome dome{.center = {0.1, -0.05}, .radii = {0.7, 0.7}, .height = 0.2};
  build.layer("all", build.everywhere(), {{0.5, 0.5, 0.5, 1}, {}, shared(Relief{.domes = {dome}})});
  const double inside = integral(
      [](double rho) {
        const double slope = 4 * 0.2 / 0.7 * rho * (1 - rho * rho);
        const double bright = kLight.ambient + (1 - kLight.ambient) / std::hypot(slope, 1);
        return 2 * pi * rho * 0.7 * 0.7 * bright;
      },
      0, 1);
  const double want = 0.5 * (4 - pi * 0.7 * 0.7 + inside);
  EXPECT_NEAR(sum_of(std::move(build).finish(), 5, 1e-6) * 4 / 25, want, 2e-6);
}

TEST(ExactLight, ABevelledStrokeHasARidgeBetweenItsSides) {
  for (const glm::dvec2 end : {glm::dvec2{9, 0}, {0, 9}, {9, 0.2}, {7, 9}}) {
    SceneBuilder build({.box = {{-0.5, -0.5}, {0.5, 0.5}}}, {0, 0, 0, 1});
    build.light(kLight);
    const Area stroke = build.shape(Line{-end, end, 4});
    build.layer("stroke", stroke, {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(stroke, 8, 3))});
    const double length = std::hypot(end.x, end.y);
    const glm::dvec2 left{-end.y / length, end.x / length};
    EXPECT_NEAR(mean_of(std::move(build)).linear.r,
                0.25 * (brightness(0.375, left) + brightness(0.375, -left)), 5e-6)
        << end.x << ' ' << end.y;
  }
}

TEST(ExactLight, ReliefsOfCombinationsHaveTheirRidgeWhereTwoOutlinesAreEquallyFar) {
  SceneBuilder build = one_pixel();
  const Area corner =
      build.intersect(build.shape(HalfPlane{{1, 0}, 1}), build.shape(HalfPlane{{0, 1}, 1}));
  build.layer("left", build.shape(HalfPlane{{1, 0}, 0.4}),
              {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(corner, 2, 1))});
  const double right = 0.08, above = 0.4 - right;  // under the diagonal, and over it
  EXPECT_NEAR(mean_of(std::move(build)).linear.r,
              0.5 * (right * brightness(0.5, {1, 0}) + above * brightness(0.5, {0, 1})), 5e-6);
}

/// At both ends of a line across the pixel the slope is the same; between 0.76 and 0.88 there is none of Gauss's places,
/// neither of the line nor of its halves.
TEST(ExactLight, TwoRidgesTurnASlopeThereAndBack) {
  for (const auto& [spine, width] : {std::pair{0.88, 0.118}, {0.9, 0.3}, {0.9, 0.04}}) {
    SceneBuilder build = one_pixel();
    const Area around = build.shell(build.shape(Line{{spine, -9}, {spine, 9}, width}), 3);
    build.layer("around", around, {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(around, 9, 4.5))});
    const double other = std::max(1 - spine - width, 0.0);
    const double left = brightness(0.5, {1, 0}), right = brightness(0.5, {-1, 0});
    // From the left to the stroke's outline, on to its spine, to its other outline, and beyond.
    const double first = spine - width, second = width, third = std::min(width, 1 - spine);
    EXPECT_NEAR(mean_of(std::move(build)).linear.r,
                0.5 * ((first + third) * right + (second + other) * left), 5e-6)
        << spine << ' ' << width;
  }
}

TEST(ExactLight, ATableHasAColourForEachStep) {
  SceneBuilder build = one_pixel();
  const Area half = build.shape(HalfPlane{{1, 0}, 1});
  build.layer("steps", half,
              {{0.5, 0.5, 0.5, 1},
               {},
               shared(Relief{.area = half,
                             .profile = Profile::custom,
                             .width = 0.9,
                             .height = 0.3,
                             .table = {0.2, 1, 0.7, 0.7}})});
  const double step = 0.3;  // of the width; a table's step of 1 rises by 0.3 / 0.3
  EXPECT_NEAR(mean_of(std::move(build)).linear.r,
              0.5 * (step * (brightness(0.8, {1, 0}) + brightness(-0.3, {1, 0}) + 1) + 0.1), 1e-7);
}

TEST(ExactLight, AHighlightIsAddedAndHeld) {
  const glm::dvec3 l = kLight.direction / std::sqrt(0.98), z{0, 0, 1};
  const glm::dvec3 h = (l + z) / std::sqrt(2 + 2 * l.z);
  for (const double slope : {0.3, 0.6, -0.3}) {
    SceneBuilder build = one_pixel();
    const Area all = build.shape(HalfPlane{{-0.6, 0.8}, 3});
    Relief relief = bevel(all, 9, 9 * slope);
    relief.specular = 0.7, relief.shininess = 12;
    build.layer("slope", all, {{0.1, 0.2, 0.9, 1}, {}, shared(relief)});
    const double facing = (slope * (-0.6 * h.x + 0.8 * h.y) + h.z) / std::hypot(slope, 1);
    const double shine = (std::pow(facing, 12) - std::pow(h.z, 12)) / (1 - std::pow(h.z, 12));
    const double added = 0.7 * std::max(0.0, shine), bright = brightness(slope, {-0.6, 0.8});
    const Mixes mean = mean_of(std::move(build));
    EXPECT_NEAR(mean.linear.r, std::min(1.0, 0.1 * bright + added), 1e-7);
    EXPECT_NEAR(mean.linear.b, std::min(1.0, 0.9 * bright + added), 1e-7);
  }
}

TEST(ExactLight, TranslucentAndGroupedSurfacesAreLitBeforeTheyAreMixed) {
  SceneBuilder build = one_pixel();
  build.layer("ground", build.everywhere(), {{0.2, 0.2, 0.2, 1}});
  build.open_group("group", 0.5);
  const Area half = build.shape(HalfPlane{{1, 0}, 1});
  build.layer("slope", half, {{0.8, 0.8, 0.8, 0.75}, {}, shared(bevel(half, 2, -1))});
  build.close_group();
  const double lit = 0.8 * brightness(-0.5, {1, 0}), a = 0.5 * 0.75;
  const Mixes mean = mean_of(std::move(build));
  EXPECT_NEAR(mean.linear.r, a * lit + (1 - a) * 0.2, 1e-7);
  EXPECT_NEAR(mean.srgb.r, a * test::encoded(lit) + (1 - a) * test::encoded(0.2), 1e-7);
}

TEST(ExactLight, LitGradientsAreMixedInTheSpaceOfThePicture) {
  SceneBuilder build = one_pixel();
  const Area half = build.shape(HalfPlane{{1, 0}, 1});
  const Gradient gradient{LinearGradient{{0, 0}, {0, 1}}, {{0, {0, 0, 0, 1}}, {1, {0.5, 0, 0, 1}}}};
  build.layer("slope", half, {{0, 0, 0, 1}, shared(gradient), shared(bevel(half, 2, 1))});
  const double bright = brightness(0.5, {1, 0}), code = test::encoded(0.5);
  const Mixes mean = mean_of(std::move(build));
  EXPECT_NEAR(mean.linear.r, 0.25 * bright, 1e-7);
  EXPECT_NEAR(
      mean.srgb.r,
      integral([&](double t) { return test::encoded(bright * test::decoded(t * code)); }, 0, 1),
      1e-6);
}

TEST(ExactLight, TheViewsLampTakesThePlaceOfTheScenes) {
  SceneBuilder build = one_pixel();
  build.light({.direction = {1, 0, 0.5}, .ambient = kLight.ambient});
  const Area all = build.shape(HalfPlane{{0, 1}, 3});
  build.layer("slope", all, {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(all, 9, 3))});
  const Scene scene = std::move(build).finish();
  const View view{.width = 1, .height = 1, .light = kLight.direction};
  EXPECT_NEAR(ExactTruth(scene, view).means(0, 0).linear.r, 0.5 * brightness(1.0 / 3, {0, 1}),
              1e-7);
}

TEST(ExactLight, UpIsUpInThePictureWhereverYPoints) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}, .y_up = false}, {0, 0, 0, 1});
  build.light(kLight);
  const Area all = build.shape(HalfPlane{{0, -1}, 3});  // falls towards smaller y: upwards
  build.layer("slope", all, {{0.5, 0.5, 0.5, 1}, {}, shared(bevel(all, 9, 3))});
  EXPECT_NEAR(mean_of(std::move(build)).linear.r, 0.5 * brightness(1.0 / 3, {0, 1}), 1e-7);
}

TEST(ExactLight, AnswersThatAreAskedForMoreExactlyAreTheSame) {
  const Scene scene = scene_from_face(test::face_named("clay"));
  const View view{.width = 128, .height = 128};
  const ExactTruth quick(scene, view, ExactTruth::kLit), fine(scene, view, 2e-6);
  for (const auto& [x, y] : {std::pair{64, 64}, {24, 32}, {40, 50}, {70, 90}, {64, 20}, {88, 64}})
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(quick.levels(x, y, 255)[k], fine.levels(x, y, 255)[k], 0.02) << x << ' ' << y;
}

TEST(ExactLight, IsWhatManySamplesSee) {
  for (const auto& [seed, x, y] : {std::tuple{6, 15, 14}, {1, 10, 18}, {23, 7, 16}}) {
    const Scene scene = test::random_lit_scene(std::uint64_t(seed));
    const ExactTruth truth(scene, {.width = 24, .height = 24}, ExactTruth::kLit);
    constexpr int kSide = 120;  // samples, each somewhere in its part of the pixel
    test::Random random(1);
    Mixes sum;
    for (int i = 0; i < kSide * kSide; ++i) {
      const double right = i % kSide + random.unit(), down = i / kSide + random.unit();
      sum = sum + truth.at(x + right / kSide, y + down / kSide);
    }
    const Mixes mean = truth.means(x, y), seen = 1.0 / (kSide * kSide) * sum;
    for (const Blend blend : {Blend::linear, Blend::srgb})
      for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(test::levels_of(mean, blend, 255)[k], test::levels_of(seen, blend, 255)[k], 0.1)
            << seed;
  }
}

}  // namespace
}  // namespace mien
