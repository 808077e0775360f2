// The first promise, from published pictures to pixels: no channel of any pixel is off by more than 1 of 255 or 32 of
// 65535 from the exact picture. What is meant is written down here by the sources' own numbers (docs/sources.md, E and
// M); what is drawn goes through face file, pose and scene.

#include <mien/mien.h>
#include "lib/picture/srgb.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

#include "tests/support/exact/exact_windows.h"
#include "tests/support/faces/faces.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random_plain_scene.h"

namespace mien {
namespace {

using test::face_named;

std::vector<std::string> eyes(glm::dvec2 gaze, double dilation, double blink) {
  return {fmt::format("gaze.x={}", gaze.x), fmt::format("gaze.y={}", gaze.y),
          fmt::format("dilation={}", dilation), fmt::format("blink={}", blink)};
}

/// The key-shape tables of the source: E4 (A, B, C, D) and E5 (lid control points), blend b in [0, 1].
template <std::size_t N>
std::array<double, N> key_shape(const std::array<std::array<double, N>, 4>& keys, double b) {
  const double s = 3 * std::clamp(b, 0.0, 1.0);
  const auto i = std::size_t(std::min(int(s), 2));
  std::array<double, N> out;
  for (std::size_t k = 0; k < N; ++k)
    out[k] = keys[i][k] + (s - double(i)) * (keys[i + 1][k] - keys[i][k]);
  return out;
}

constexpr std::array<std::array<double, 4>, 4> kOpenings{
    {{.9, .04, -1, .34}, {.7, .06, -.7, .30}, {.5, .10, -.4, .24}, {.3, .20, -.1, .20}}};
constexpr std::array<std::array<double, 6>, 4> kLids{{{.01, .19, .26, .50, .47, .15},
                                                      {.01, .19, .30, .44, .47, .15},
                                                      {.01, .19, .30, .32, .47, .15},
                                                      {.01, .19, .30, .23, .47, .17}}};

/// k0 q² + k1 <= y <= k2 q² + k3, where q = 1.8 (x − shift) − 0.42.
Band lens(const std::array<double, 4>& k, double shift) {
  const double x = shift + 0.42 / 1.8;
  return {{{x, k[1]}, {0, 1}, 1.8 * 1.8 * k[0]}, {{x, k[3]}, {0, -1}, -1.8 * 1.8 * k[2]}};
}

/// The published eyes at a pose (E1 – E7, E10).
Scene published_eyes(glm::dvec2 gaze, double dilation, double blink) {
  SceneBuilder build({.box = {{0, 0}, {1, 0.5625}}}, color_from_srgb255(247, 219, 156));
  const Paint white{{1, 1, 1, 1}}, black{{0, 0, 0, 1}};
  for (const bool second : {false, true}) {
    const double shift = second ? 0.53 : 0;
    const Area open = build.shape(lens(key_shape(kOpenings, blink), shift));
    const glm::dvec2 center = glm::dvec2{second ? .76 : .23, .19} + gaze;
    build.layer("white", build.intersect(build.shape(lens(kOpenings[0], shift)), open), white);
    const Area pupil = build.shape(Ellipse{center, dilation * glm::dvec2{.09, .105}});
    build.layer("pupil", build.intersect(pupil, open), black);
  }
  const auto lid = key_shape(kLids, blink);
  for (const bool second : {false, true}) {
    const auto m = [&](double x, double y) { return glm::dvec2{second ? 1 - x : x, y}; };
    const QuadStroke strokes[] = {
        {{m(lid[0], lid[1]), m(lid[2], lid[3]), m(lid[4], lid[5])}, .0095},
        {{m(.44, .35), m(.17, .52), m(.03, .41)}, .0215},
        {{m(.44, .35), m(.14, .61), m(.03, .41)}, .0255}};
    for (const QuadStroke& stroke : strokes) build.layer("line", build.shape(stroke), black);
  }
  return std::move(build).finish();
}

/// The published muscle face at rest (M1 – M3).
Scene published_male() {
  SceneBuilder build({.box = {{-200, -120}, {200, 280}}, .y_up = false}, {1, 1, 1, 1});
  const Paint ink{{0, 0, 0, 1}};
  const Polyline lines[] = {{{{40, -34}, {112, -45}, {142, -36}}, 2.5},
                            {{{0, 170}, {30, 170}, {60, 170}, {30, 172}, {0, 172}}, 2.5},
                            {{{50, 5}, {65, -15}, {105, -15}, {120, 5}}, 0.75},
                            {{{0, 115}, {30, 112}}, 2.5},
                            {{{0, 229}, {10, 230}}, 2.5}};
  for (const double side : {1.0, -1.0}) {
    for (Polyline line : lines) {
      for (glm::dvec2& p : line.points) p.x *= side;
      build.layer("line", build.shape(line), ink);
    }
    build.layer("eye", build.shape(CutDisc{{82 * side, 0}, 13, .94, .7, {0, 1}}), ink);
  }
  return std::move(build).finish();
}

/// Whether `drawn` is the picture that is `meant`; of its pixels that have an outline, one in `every` is judged.
void expect_exact(const Scene& drawn, const Scene& meant, int width, int height, int every) {
  const View view{.width = width, .height = height, .dither = false};
  const test::ExactTruth truth(meant, view, test::ExactTruth::kLit);
  const auto chosen = [&](int x, int y) {
    const auto hash = (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca6bu);
    return (hash >> 8) % std::uint32_t(every * test::kThinning) == 0;
  };
  test::Tallies tallies;
  test::judge_window(drawn, view, {0, 0, width, height}, truth, test::kAllStorages, chosen,
                     tallies);
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    EXPECT_GT(tallies[i].judged, 0);
    EXPECT_EQ(tallies[i].over, 0) << test::kStorages[i].name << ": " << tallies[i].where;
  }
}

void expect_eyes(glm::dvec2 gaze, double dilation, double blink, int width, int height, int every) {
  SCOPED_TRACE(fmt::format("{}x{} gaze {} {} dilation {} blink {}", width, height, gaze.x, gaze.y,
                           dilation, blink));
  expect_exact(scene_from_face(test::posed(face_named("seed0"), eyes(gaze, dilation, blink))),
               published_eyes(gaze, dilation, blink), width, height, every);
}

TEST(Exact, EyesLookingUpRight) {  // E1 – E7, E12
  expect_eyes({0.03, -0.02}, 1, 0, 640, 360, 3);
}

TEST(Exact, EyesWithThePupilCutByTheLowerLid) {  // E4
  expect_eyes({0.05, -0.09}, 1, 0, 640, 360, 3);
}

TEST(Exact, TheMuscleFaceAtRest) {  // M1 – M3
  expect_exact(scene_from_face(face_named("male")), published_male(), 512, 512, 1);
}

TEST(Exact, AHundredRandomPosesAtRandomSizes) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < (test::kSanitized ? 20 : 100); ++i) {
    const int width = 24 + int(unit(random) * 400), height = 16 + int(unit(random) * 240);
    const glm::dvec2 gaze{0.16 * unit(random) - 0.08, 0.14 * unit(random) - 0.07};
    const double dilation = 0.7 + 0.5 * unit(random), blink = unit(random);
    expect_eyes(gaze, dilation, blink, width, height, 12);
  }
}

TEST(Exact, RandomScenesOfEveryShapeAndOperator) {
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 30 : 150); ++seed) {
    const int side = seed % 3 == 0 ? 11 : seed % 3 == 1 ? 24 : 40;
    const Scene scene = test::random_plain_scene(seed);
    SCOPED_TRACE(fmt::format("seed {} at {} px:\n{}", seed, side, scene.text()));
    expect_exact(scene, scene, side, side, 4);
  }
}

TEST(Exact, EyesThatAreOthersAreSeenToBe) {
  const Scene drawn = scene_from_face(test::posed(face_named("seed0"), eyes({0.03, -0.02}, 1, 0)));
  const View view{.width = 320, .height = 180, .dither = false};
  const Scene other = published_eyes({0.031, -0.02}, 1, 0);
  const test::ExactTruth truth(other, view, test::ExactTruth::kLit);
  test::Tallies tallies;
  test::judge_window(
      drawn, view, {0, 0, 320, 180}, truth, test::kAllStorages, [](int, int) { return true; },
      tallies);
  for (const test::Tally& tally : tallies) EXPECT_GT(tally.over, 0);
}

}  // namespace
}  // namespace mien
