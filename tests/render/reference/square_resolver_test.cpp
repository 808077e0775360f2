#include "render/reference/square_resolver.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/changed_scene.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random_plain_scene.h"
#include "tests/support/random/random_scene.h"

namespace mien {
namespace {

constexpr Color kInk{0, 0, 0, 1}, kPaper{1, 1, 1, 1};

/// The red of every pixel of a picture with one pixel per face unit.
double sum_of_red(const Scene& scene, int side, double& bound) {
  const View view{.width = side, .height = side};
  PaintTable paints;
  paints.make(scene, view, Depth::u8);
  SquareResolver resolver(scene, view, paints, 1e-5);
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Resolved found = resolver.pixel(x, y);
      sum += found.mix.r;
      bound += found.bound;
    }
  return sum;
}

TEST(SquareResolver, KnowsTheAreaOfADisc) {
  SceneBuilder build({.box = {{0, 0}, {12, 12}}}, kInk);
  build.layer("disc", build.shape(Disc{{6.1, 5.7}, 3.3}), {kPaper});
  double bound = 0;
  EXPECT_NEAR(sum_of_red(std::move(build).finish(), 12, bound), std::numbers::pi * 3.3 * 3.3, 1e-3);
  EXPECT_LT(bound, 0.2);
}

/// Of straight outlines nothing is left out: an eighth of the tolerance stands for what lies between places.
TEST(SquareResolver, KnowsAStraightEdgeAsWellAsItMeasures) {
  SceneBuilder build({.box = {{0, 0}, {4, 4}}}, kInk);
  build.layer("edge", build.shape(HalfPlane{{0.6, 0.8}, 2.9}), {kPaper});
  const Scene scene = std::move(build).finish();
  const View view{.width = 4, .height = 4};
  PaintTable paints;
  paints.make(scene, view, Depth::u8);
  constexpr double kTolerance = 1e-5;
  SquareResolver resolver(scene, view, paints, kTolerance);
  int crossed = 0;
  for (int i = 0; i < 16; ++i) {
    const Resolved found = resolver.pixel(i % 4, i / 4);
    if (found.mix.r <= 0.0 || found.mix.r >= 1.0) continue;
    ++crossed;
    EXPECT_NEAR(found.bound, 0.125 * kTolerance, 1e-12) << i;
  }
  EXPECT_GT(crossed, 3);
}

TEST(SquareResolver, LetsNothingShineThroughBetweenLayersThatAbut) {
  SceneBuilder build({.box = {{0, 0}, {4, 4}}}, kInk);
  const Area left = build.shape(HalfPlane{{0.6, 0.8}, 2.9});
  build.layer("left", left, {kPaper});
  build.layer("right", build.complement(left), {kPaper});
  double bound = 0;
  EXPECT_NEAR(sum_of_red(std::move(build).finish(), 4, bound), 16, 1e-3);
}

TEST(SquareResolver, TakesTheMeanOfARadialGradientWithAJump) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, kInk);
  build.layer("all", build.everywhere(),
              {.color = kInk,
               .gradient = shared(Gradient{RadialGradient{{0.1, 0}, {0.5, 0.25}},
                                           {{0, kInk}, {1, kPaper}, {1, kInk}}})});
  double bound = 0;  // a cone within the ellipse: 2/3 of its area
  EXPECT_NEAR(4 * sum_of_red(std::move(build).finish(), 1, bound),
              2.0 / 3 * std::numbers::pi * 0.5 * 0.25, 4e-3);
}

// Its word: no pixel is farther from the truth than its bound says, and bounds are small.

struct Word {
  long pixels = 0, broken = 0;
  double worst = 0, bounds = 0;
  std::string where;
};

/// `to_judge`: the scene resolved may be another than that it is judged by.
void keep_to(const Scene& scene, const Scene& to_judge, int side, int every, Word& word) {
  constexpr double kTolerance = 0x1p-14, kTruth = 2e-6;
  const View view{.width = side, .height = side, .blend = Blend::srgb, .dither = false};
  PaintTable paints;
  paints.make(scene, view, Depth::u16);
  SquareResolver resolver(scene, view, paints, kTolerance);
  const test::ExactTruth truth(to_judge, view);
  for (int y = 0; y < side; ++y)
    for (int x = y % every; x < side; x += every) {
      const Resolved found = resolver.pixel(x, y);
      const double off = test::largest(found.mix - truth.pixel(x, y));
      ++word.pixels, word.bounds += found.bound, word.worst = std::max(word.worst, off);
      if (off > found.bound + kTruth) {
        ++word.broken;
        word.where = fmt::format("({}, {}) off {:.2e}, bound {:.2e}", x, y, off, found.bound);
      }
    }
}

void expect_kept(const Word& word, double worst, double mean_bound) {
  EXPECT_EQ(word.broken, 0) << word.where;
  EXPECT_LT(word.worst, worst);
  EXPECT_LT(word.bounds / double(word.pixels), mean_bound);
}

TEST(SquareResolver, KeepsItsBoundOnRandomScenes) {
  Word word;
  for (int seed = 1; seed <= test::times(12); ++seed) {
    const Scene scene = test::random_plain_scene(std::uint64_t(seed));
    keep_to(scene, scene, 12, 1, word);
  }
  expect_kept(word, 32.0 / 65535, 1e-4);
}

TEST(SquareResolver, KeepsItsBoundOnLatticesAndNearThem) {
  for (const double jitter : {0.0, 1e-13, 1e-6, 1e-3}) {
    Word word;
    for (int seed = 1; seed <= test::times(4); ++seed) {
      const Scene scene = test::degenerate_scene(std::uint64_t(seed), jitter);
      keep_to(scene, scene, 12, 7, word);
    }
    SCOPED_TRACE(jitter);
    expect_kept(word, 64.0 / 65535, 1e-3);
  }
}

TEST(SquareResolver, KeepsItsBoundWherePaintsVary) {
  Word word;
  for (int seed = 1; seed <= test::times(6); ++seed) {
    const Scene scene = test::random_painted_scene(std::uint64_t(seed));
    keep_to(scene, scene, 7, 2, word);
  }
  expect_kept(word, 64.0 / 65535, 1e-3);
}

TEST(SquareResolver, KeepsItsBoundWhereGroupsMix) {
  Word word;
  for (int seed = 1; seed <= test::times(8); ++seed) {
    const auto number = std::uint64_t(seed);
    const Scene scene = test::mixed_scene(test::random_plain_scene(number), number);
    keep_to(scene, scene, 9, 2, word);
  }
  expect_kept(word, 32.0 / 65535, 1e-4);
}

/// Its bound is an estimate there: of two gradients that are multiplied it may be a fifth too small.
TEST(SquareResolver, IsNearTheTruthWhereGradientsMix) {
  Word word;
  for (int seed = 1; seed <= test::times(6); ++seed) {
    const auto number = std::uint64_t(seed);
    const Scene scene = test::mixed_scene(test::random_painted_scene(number), number);
    keep_to(scene, scene, 7, 2, word);
  }
  EXPECT_LT(word.worst, 64.0 / 65535);
}

/// The first layer's shape grown by a little.
Scene grown(const Scene& scene, double by) {
  SceneBuilder build(scene.canvas(), scene.background());
  std::vector<Area> areas;
  for (const Shape& shape : scene.shapes()) {
    const Area area = build.shape(shape);
    areas.push_back(areas.empty() ? build.offset(area, by) : area);
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
    build.layer("layer", areas[i], scene.layers()[0].paint);
  return std::move(build).finish();
}

TEST(SquareResolver, ThatATruthIsAnotherIsSeen) {  // a hundredth of a pixel
  SceneBuilder build({.box = {{0, 0}, {12, 12}}}, kInk);
  build.layer("disc", build.shape(Disc{{6.1, 5.7}, 3.3}), {kPaper});
  const Scene scene = std::move(build).finish();
  Word same, other;
  keep_to(scene, scene, 12, 1, same);
  keep_to(grown(scene, 0.01), scene, 12, 1, other);
  EXPECT_EQ(same.broken, 0) << same.where;
  EXPECT_GT(other.broken, 15);
}

TEST(SquareResolver, AsksFewDistances) {
  const Scene scene = test::random_plain_scene(1);
  const View view{.width = 24, .height = 24};
  PaintTable paints;
  paints.make(scene, view, Depth::u16);
  SquareResolver resolver(scene, view, paints, 0x1p-14);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) resolver.pixel(x, y);
  EXPECT_LT(resolver.stats().distances, 24 * 24 * 40);
}

TEST(SquareResolver, KnowsPathsOverThemselvesAndThinStrokes) {
  SceneBuilder build({.box = {{0, 0}, {8, 8}}}, kInk);
  const auto side = [](glm::dvec2 p, glm::dvec2 q) { return QuadBezier{p, 0.5 * (p + q), q}; };
  Path path;  // two squares, one over the other: 4 × 4 and 3 × 3, in common 2 × 2
  for (const auto& [lo, hi] : {std::pair{1.3, 5.3}, {3.3, 6.3}})
    path.loops.push_back({{side({lo, lo}, {hi, lo}), side({hi, lo}, {hi, hi}),
                           side({hi, hi}, {lo, hi}), side({lo, hi}, {lo, lo})}});
  build.layer("path", build.shape(path), {kPaper});
  build.layer("line", build.shape(Line{{0.1, 7.3}, {7.9, 7.1}, 0.003}), {kPaper});
  double bound = 0;
  const double line = 0.006 * std::hypot(7.8, 0.2) + std::numbers::pi * 0.003 * 0.003;
  EXPECT_NEAR(sum_of_red(std::move(build).finish(), 8, bound), 16 + 9 - 4 + line, 1e-4);
}

}  // namespace
}  // namespace mien
