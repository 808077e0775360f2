// The first promise on the sample faces and under light: no channel of any pixel is off by more than
// 1 of 255 or 32 of 65535 from the exact picture, not rounded, in either blend.
//
// A slice of what mien_exactness judges, about a minute of it. The long form of the random scenes
// under light: MIEN_RANDOM_SCENES=1000, MIEN_FIRST_SCENE=501 to begin later.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/exact/exact_windows.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/sample_poses.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/asked.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/changed_scene.h"
#include "tests/support/random/random_lit_scene.h"

namespace mien {
namespace {

using test::ExactTruth;
using test::Tallies;

enum class Pixels { unlit, lit, all };

/// Some of the pixels of a kind, one in `every`, without a pattern.
test::Choice some(const ExactTruth& truth, Pixels kind, int every) {
  return [&truth, kind, every](int x, int y) {
    const auto hash = (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca6bu);
    if ((hash >> 8) % std::uint32_t(every * test::kThinning) != 0) return false;
    return kind == Pixels::all || truth.lit(x, y) == (kind == Pixels::lit);
  };
}

void expect_exact(const Tallies& tallies) {
  for (std::size_t i = 0; i < tallies.size(); ++i)
    EXPECT_EQ(tallies[i].over, 0) << test::kStorages[i].name << ": " << tallies[i].where;
}

View view_of(const Scene& scene, int width) {
  const glm::dvec2 canvas = scene.canvas().box.size();
  return {.width = width, .height = int(std::lround(width * canvas.y / canvas.x)), .dither = false};
}

void expect_exact(const Scene& scene, const View& view, Pixels kind, int every,
                  const test::Wanted& wanted = test::kAllStorages) {
  const ExactTruth truth(scene, view, ExactTruth::kLit);
  Tallies tallies;
  test::judge_window(scene, view, {0, 0, view.width, view.height}, truth, wanted,
                     some(truth, kind, every), tallies);
  SCOPED_TRACE(fmt::format("{} px wide", view.width));
  expect_exact(tallies);
}

class ExactFaces : public testing::TestWithParam<const char*> {
 protected:
  /// The face in all its poses, small.
  void expect_exact_poses(Pixels kind) {
    const Face face = test::face_named(GetParam());
    for (const test::NamedPose& pose : test::sample_poses(face)) {
      SCOPED_TRACE(pose.name);
      const Scene scene = scene_from_face(pose_face(face, pose.pose));
      expect_exact(scene, view_of(scene, 37), kind, 11);
      expect_exact(scene, view_of(scene, 71), kind, 41);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Of, ExactFaces, testing::ValuesIn(test::kSampleFaces),
                         [](const auto& which) {
                           std::string name = which.param;
                           std::ranges::replace(name, '/', '_');
                           return name;
                         });

TEST_P(ExactFaces, AreWithinALevelInEveryPose) {
  expect_exact_poses(Pixels::unlit);
}

TEST_P(ExactFaces, AreWithinALevelWhereLightFallsOnSlopes) {
  expect_exact_poses(Pixels::lit);
}

TEST_P(ExactFaces, AreWithinALevelOverATransparentBackground) {
  const Scene scene = scene_from_face(test::face_named(GetParam()));
  View view = view_of(scene, 53);
  view.background = Color{0, 0, 0, 0};
  expect_exact(scene, view, Pixels::all, 23);
}

TEST_P(ExactFaces, AreWithinTwoLevelsDithered) {
  const Scene scene = scene_from_face(test::face_named(GetParam()));
  View view = view_of(scene, 61);
  view.dither = true;
  expect_exact(scene, view, Pixels::all, 19);
}

struct LargePicture {
  int width, windows;
  int unlit, lit;  ///< one pixel in so many is judged
};

TEST_P(ExactFaces, AreWithinALevelInWindowsOfLargePictures) {
  const Scene scene = scene_from_face(test::face_named(GetParam()));
  for (const LargePicture& of : {LargePicture{1920, 120, 5, 5}, {7680, 240, 3, 61}}) {
    const View view = view_of(scene, of.width);
    const ExactTruth truth(scene, view, ExactTruth::kLit);
    const test::Choice unlit = some(truth, Pixels::unlit, of.unlit),
                       lit = some(truth, Pixels::lit, of.lit);
    Tallies tallies;
    for (const PixelRect& window : test::windows_of(scene, view, 16, test::times(of.windows), 2, 7))
      test::judge_window(
          scene, view, window, truth, test::kAllStorages,
          [&](int x, int y) { return unlit(x, y) || lit(x, y); }, tallies);
    SCOPED_TRACE(of.width);
    expect_exact(tallies);
    EXPECT_GT(tallies[0].judged, 0);
  }
}

/// Edges of highlights and shadows: kinks that lay between the places at which light was looked at, by the truth at
/// 97 px. Rims of glasses narrower than a pixel, and their bridge.
TEST(ExactLitFaces, ThatWereWrongOnceAreRight) {
  struct Place {
    const char *face, *pose;
    int width, x, y;
  };
  for (const Place& p : {Place{"clay", "rest", 333, 183, 28},
                         {"clay", "rest", 333, 213, 88},
                         {"clay", "rest", 640, 169, 187},
                         {"clay", "unwrap_half", 333, 151, 223},
                         {"clay", "unwrap_half", 333, 185, 235},
                         {"clay", "unwrap_half", 1920, 1545, 692},
                         {"faces/clay", "surprise", 48, 24, 19},
                         {"faces/clay", "anger", 48, 22, 22},
                         {"faces/clay", "joy", 48, 23, 21},
                         {"faces/clay", "turn_right", 48, 20, 17},
                         {"faces/clay", "rest", 97, 41, 52},
                         {"faces/clay", "joy", 333, 180, 144},
                         {"faces/clay", "anger", 640, 319, 280},
                         {"faces/clay", "rest", 64, 24, 17},
                         {"faces/clay", "rest", 333, 255, 162},
                         {"faces/clay", "rest", 333, 319, 330},
                         {"faces/clay", "rest", 1920, 956, 813}}) {
    const Face face = test::face_named(p.face);
    const std::vector<test::NamedPose> poses = test::sample_poses(face);
    const auto pose = std::ranges::find(poses, p.pose, &test::NamedPose::name);
    ASSERT_NE(pose, poses.end());
    const Scene scene = scene_from_face(pose_face(face, pose->pose));
    const View view = view_of(scene, p.width);
    Tallies tallies;
    test::judge_window(
        scene, view, {p.x - 1, p.y - 1, 3, 3}, ExactTruth(scene, view, ExactTruth::kLit),
        test::kAllStorages, [](int, int) { return true; }, tallies);
    SCOPED_TRACE(fmt::format("{} {} at {}", p.face, p.pose, p.width));
    expect_exact(tallies);
  }
}

/// Outlines whose order is not proven would be drawn by distances: right, but slow.
TEST_P(ExactFaces, HaveNoDoubtsAtAnySize) {
  const Face face = test::face_named(GetParam());
  for (const test::NamedPose& pose : test::sample_poses(face))
    for (const int width : {48, 97, 160, 640, 1920, 7680})
      for (const Blend blend : {Blend::srgb, Blend::linear})
        for (const Depth depth : {Depth::u8, Depth::u16}) {
          const Scene scene = scene_from_face(pose_face(face, pose.pose));
          View view = view_of(scene, width);
          view.blend = blend, view.region = PixelRect{0, 0, 1, 1};
          RenderStats stats;
          test::rendered(scene, view, {.depth = depth}, &stats);
          EXPECT_EQ(stats.doubts, 0) << pose.name << ' ' << width;
        }
}

/// A level edge covers a share of a row for many pixels. What is varied has nothing as its constant part, as a
/// transparent background has: the row once went on as if it were full, to the picture's side.
TEST(ExactLitScenes, WithALevelEdgeOverNothingAreWithinALevel) {
  for (const double below : {3.0, 3.3, 3.8})
    for (const double right : {11.4, 40.0}) {
      SceneBuilder build({.box = {{0, 0}, {24, 16}}}, {0, 0, 0, 0});
      build.light({.direction = {-0.3, 0.5, 0.8}, .ambient = 0.4});
      const auto side = [](glm::dvec2 a, glm::dvec2 b) { return QuadBezier{a, 0.5 * (a + b), b}; };
      const glm::dvec2 a{4.5, below}, b{right, below}, c{right, 12}, d{8, 12};
      const Area box = build.shape(Path{{{{side(a, b), side(b, c), side(c, d), side(d, a)}}}, {}});
      const Relief relief{.area = box, .profile = Profile::round, .width = 5, .height = 3};
      build.layer("box", box, {{0.5, 0.25, 0.1, 1}, {}, shared(relief)});
      const Scene scene = std::move(build).finish();
      SCOPED_TRACE(fmt::format("{} {}", below, right));
      expect_exact(scene, {.width = 24, .height = 16, .dither = false}, Pixels::all, 1);
    }
}

TEST(ExactLitScenes, OfEveryProfileDomeAndPaintAreWithinALevel) {
  const bool few = !std::getenv("MIEN_RANDOM_SCENES");
  const int first = test::asked_of("MIEN_FIRST_SCENE", 1);
  for (int seed = first; seed < first + test::asked_of("MIEN_RANDOM_SCENES", 12); ++seed) {
    const Scene scene = test::random_lit_scene(std::uint64_t(seed));
    SCOPED_TRACE(fmt::format("seed {}:\n{}", seed, scene.text()));
    const int side = seed % 3 == 0 ? 9 : seed % 3 == 1 ? 17 : 40;
    expect_exact(scene, {.width = side, .height = side, .dither = false}, Pixels::all,
                 few ? 4 + side : 5);
  }
}

/// Highlights that are narrow at the foot of a dome, steep ramps under light, thin lines under wide round profiles: cells
/// were taken for small, and the reference looked at such pixels in too few places. A side that ends in a square's
/// corner, a tapered stroke that turns back, a relief of another area than the layer's. Ridges and highlights that cut off a
/// pixel's corner, parabolas cut at their vertex by chance, kinks between two depths of a cell, roots in the dark.
/// Kinks and ridges in parts of few cells, radial ramps at their centre, squares whose border a curve ends at, sums that
/// agreed by chance; and two ridges that turn a slope there and back, which the judge took for none. Highlights narrower
/// than a cell at an outline, dark parts of a pixel in linear light, light under what fades.
TEST(ExactLitScenes, ThatWereWrongOnceAreRight) {
  struct Place {
    std::uint64_t seed;
    int x, y;
  };
  for (const Place& p :
       {Place{500030, 39, 29}, {500043, 1, 6},    {500043, 2, 6},   {500082, 5, 7},
        {500102, 13, 31},      {500131, 0, 3},    {500131, 1, 7},   {500158, 12, 7},
        {500169, 5, 7},        {500169, 6, 5},    {500182, 5, 7},   {500188, 10, 11},
        {500197, 5, 7},        {500197, 6, 9},    {500246, 1, 30},  {500246, 21, 11},
        {500266, 2, 15},       {600001, 14, 3},   {600012, 0, 1},   {600012, 5, 1},
        {700018, 8, 12},       {700049, 10, 28},  {700095, 0, 3},   {710051, 34, 5},
        {710079, 2, 1},        {710106, 7, 7},    {710150, 30, 33}, {710150, 25, 32},
        {710177, 22, 8},       {710230, 0, 0},    {710230, 5, 1},   {730032, 0, 0},
        {730082, 31, 16},      {730106, 15, 21},  {730106, 25, 5},  {730135, 4, 14},
        {730135, 14, 4},       {742002, 7, 2},    {742006, 8, 13},  {742007, 15, 20},
        {743031, 6, 0},        {743154, 1, 7},    {744032, 31, 28}, {750120, 6, 5},
        {750181, 15, 7},       {750181, 12, 7},   {750404, 12, 13}, {750483, 2, 1},
        {750503, 22, 18},      {750577, 15, 8},   {750815, 19, 23}, {751608, 0, 1},
        {751830, 0, 0},        {751869, 4, 6},    {751919, 18, 16}, {752059, 11, 3},
        {752101, 11, 3},       {752450, 19, 12},  {752902, 13, 11}, {752918, 27, 24},
        {751355, 12, 15},      {751774, 15, 7},   {760478, 15, 37}, {761185, 14, 9},
        {900818, 17, 14},      {960419, 14, 23},  {960785, 16, 36}, {960785, 15, 35},
        {2000221, 7, 2},       {2000677, 11, 13}, {2000715, 0, 3},  {3000232, 14, 1},
        {3000971, 35, 37},     {3001283, 15, 7},  {3001470, 2, 6},  {3001644, 4, 6},
        {3002069, 22, 14},     {3002560, 0, 1},   {2000766, 0, 5},  {3002193, 2, 7}}) {
    const Scene scene = test::random_lit_scene(p.seed);
    const int side = p.seed % 3 == 0 ? 9 : p.seed % 3 == 1 ? 17 : 40;
    const View view{.width = side, .height = side, .dither = false};
    Tallies tallies;
    test::judge_window(
        scene, view, {p.x, p.y, 1, 1}, ExactTruth(scene, view, ExactTruth::kLit),
        test::kAllStorages, [](int, int) { return true; }, tallies);
    SCOPED_TRACE(fmt::format("seed {}", p.seed));
    expect_exact(tallies);
  }
}

TEST(ExactLitScenes, WhoseGroupsMixByEveryModeAreWithinALevel) {
  for (int seed = 1; seed <= test::asked_of("MIEN_RANDOM_SCENES", 6); ++seed) {
    const auto word = std::uint64_t(seed);
    const Scene scene = test::mixed_scene(test::random_lit_scene(word), word);
    SCOPED_TRACE(fmt::format("seed {}:\n{}", seed, scene.text()));
    const int side = seed % 2 ? 9 : 24;
    expect_exact(scene, {.width = side, .height = side, .dither = false}, Pixels::all, 5 + side);
  }
}

/// A path of so many wedges, whose tips meet in one pixel.
Path fan(int wedges) {
  const glm::dvec2 middle{0.03, 0.04};
  const auto rim = [&](int i) {
    const double turn = std::numbers::pi * i / wedges;
    return middle + 0.8 * glm::dvec2{std::cos(turn), std::sin(turn)};
  };
  Path path{{Path::Loop{}}, FillRule::even_odd};
  const auto side_to = [&](glm::dvec2 from, glm::dvec2 to) {
    path.loops[0].sides.push_back({from, 0.5 * (from + to), to});
  };
  for (int i = 0; i < 2 * wedges; i += 2)
    side_to(middle, rim(i)), side_to(rim(i), rim(i + 1)), side_to(rim(i + 1), middle);
  return path;
}

TEST(ExactLitScenes, PixelsOfMoreBranchesThanATileHoldsAreWithinALevel) {
  for (const bool lit : {true, false}) {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
    build.light({.direction = {-0.4, 0.5, 0.8}, .ambient = 0.3});
    const Area area = build.shape(fan(40));
    Paint paint{.color = {0.6, 0.4, 0.3, 1}};
    if (lit)
      paint.relief = shared({.area = area, .profile = Profile::bevel, .width = 0.2, .height = 0.1});
    else
      paint.gradient = shared({.along = DistanceGradient{area, -0.1, 0.0},
                               .stops = {{0, {0.1, 0.2, 0.6, 1}}, {1, {0.8, 0.1, 0.1, 1}}}});
    build.layer("fan", area, paint);
    const Scene scene = std::move(build).finish();
    const View view{.width = 9, .height = 9, .dither = false};
    RenderStats stats;
    ASSERT_TRUE(render(scene, view, {}, &stats));
    EXPECT_GT(stats.resolved_pixels, 0);
    expect_exact(scene, view, Pixels::all, 4);
  }
}

// What judges light must see it go wrong.

struct LitNose {
  Relief relief{.profile = Profile::custom,
                .width = 0.25,
                .height = 0.2,
                .table = {0, 0.7, 1, 0.9},
                .domes = {{.center = {0.05, 0.35}, .radii = {0.3, 0.2}, .height = 0.08}},
                .specular = 0.6,
                .shininess = 25};
  Light light{.direction = {-0.4, 0.5, 0.8}, .ambient = 0.3};

  Scene scene() const {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.3, 0.4, 0.5, 1});
    build.light(light);
    Relief own = relief;
    own.area = build.shape(TaperedStroke{{{0.1, 0.7}, {0.3, 0.1}, {-0.2, -0.5}}, {0.2, 0.3, 0.4}});
    build.layer("nose", own.area, {.color = {0.6, 0.4, 0.3, 1}, .relief = shared(own)});
    return std::move(build).finish();
  }
};

/// Pixels that differ if one is drawn and the other was meant.
long seen_between(const LitNose& drawn, const LitNose& meant) {
  const View view{.width = 24, .height = 24, .dither = false};
  const Scene scene = meant.scene();
  const ExactTruth truth(scene, view, ExactTruth::kLit);
  Tallies tallies;
  test::judge_window(
      drawn.scene(), view, {0, 0, 24, 24}, truth, {true, false, false, false},
      [](int, int) { return true; }, tallies);
  return tallies[0].over;
}

TEST(ExactLitScenes, OfOtherLightAreSeenToBe) {
  const LitNose meant;
  EXPECT_EQ(seen_between(meant, meant), 0);
  LitNose drawn = meant;
  drawn.light.direction.y = -0.5;  // normals upside down
  EXPECT_GT(seen_between(drawn, meant), 20);
  drawn = meant, drawn.relief.domes.clear();
  EXPECT_GT(seen_between(drawn, meant), 1);
  drawn = meant, drawn.relief.table[1] = 0.65;
  EXPECT_GT(seen_between(drawn, meant), 1);
  drawn = meant, drawn.relief.shininess = 20;
  EXPECT_GT(seen_between(drawn, meant), 1);
  drawn = meant, drawn.light.direction.x = -0.38;
  EXPECT_GT(seen_between(drawn, meant), 1);
}

}  // namespace
}  // namespace mien
