// What no one should draw: numbers that are none, that are huge, or the same a thousand times. Pictures are right
// and work is bounded by pieces and crossings, as RenderStats tells.

#include <mien/render.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/fuzzed_picture.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

constexpr Color kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN(), kInfinite = HUGE_VAL;

QuadBezier side(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

SceneBuilder canvas(double size) {
  return SceneBuilder({.box = {{0, 0}, {size, size}}}, kBlack);
}

Scene only(const Shape& shape, double size = 24) {
  SceneBuilder build = canvas(size);
  build.layer("only", build.shape(shape), {kWhite});
  return std::move(build).finish();
}

void expect_right(const Scene& scene, int size = 24) {
  FuzzTally tally;
  judge_fuzzed(scene, size, tally);
  EXPECT_EQ(tally.over, 0) << tally.where;
}

/// A shape of every kind, one of its numbers v.
std::vector<Shape> with_number(double v) {
  return {Disc{{v, 12}, 5},
          Disc{{12, 12}, v},
          Ellipse{{12, v}, {5, 3}},
          Ellipse{{12, 12}, {5, v}},
          CutDisc{{v, 12}, 5, 0.5, 0.5, {0, 1}},
          Triangle{{2, 2}, {20, 3}, {v, 20}},
          Line{{2, 2}, {20, v}, 2},
          Line{{2, 2}, {20, 9}, v},
          Polyline{{{2, 2}, {20, v}, {9, 9}}, 2},
          QuadStroke{{{2, 2}, {v, 9}, {20, 20}}, 2},
          TaperedStroke{{{2, 2}, {20, 9}, {v, 20}}, {1, 2, 1}},
          TaperedStroke{{{2, 2}, {20, 9}, {3, 20}}, {1, v, 1}},
          Path{{{{side({2, 2}, {20, v}), side({20, v}, {9, 20}), side({9, 20}, {2, 2})}}}}};
}

TEST(BadInput, ShapesWithNumbersThatAreNoneAreNotThere) {
  const Image empty = test::rendered(canvas(24).finish(), {.width = 24, .height = 24});
  for (const double v : {kNone, kInfinite, -kInfinite})
    for (const Shape& shape : with_number(v)) {
      SCOPED_TRACE(fmt::format("{} with {}", shape_name(shape), v));
      const Scene scene = only(shape);
      EXPECT_EQ(test::rendered(scene, {.width = 24, .height = 24}).bytes, empty.bytes);
      EXPECT_EQ(scene.distance(scene.layers()[0].area, {12, 12}), kInfinite);
    }
}

/// Beside such numbers places in the picture have no digits left: there is a picture, at once.
TEST(BadInput, NumbersBeyondAllPicturesEnd) {
  for (const double v : {1e15, -1e30, 1e150, 1e300, -1e308})
    for (const Shape& shape : with_number(v)) {
      RenderStats stats;
      test::rendered(only(shape), {.width = 24, .height = 24}, {}, &stats);
      EXPECT_LT(stats.pieces, 100'000) << shape_name(shape) << ' ' << v;
    }
}

TEST(BadInput, HugeNumbersGiveWhatTheDistanceSays) {
  for (const double v : {1e5, -1e5, 1e8, -1e8, 1e-12, 1e-300})
    for (const Shape& shape : with_number(v)) {
      SCOPED_TRACE(fmt::format("{} with {}", shape_name(shape), v));
      expect_right(only(shape));
    }
}

TEST(BadInput, WhatHasNoWidthIsNotSeen) {
  const Image empty = test::rendered(canvas(24).finish(), {.width = 24, .height = 24});
  for (const double none : {0.0, -0.0}) {
    SceneBuilder build = canvas(24);
    for (const Shape& shape : std::vector<Shape>{
             Disc{{12, 12}, none}, Ellipse{{12, 12}, {none, 5}}, Ellipse{{12, 12}, {5, none}},
             Line{{2, 2}, {20, 19}, none}, Polyline{{{2, 2}, {20, 9}, {3, 20}}, none},
             QuadStroke{{{2, 2}, {20, 9}, {3, 20}}, none},
             TaperedStroke{{{2, 2}, {20, 9}, {3, 20}}, {none, none, none}},
             CutDisc{{12, 12}, none, 0.5, 0.5, {0, 1}}})
      build.layer("none", build.shape(shape), {kWhite});
    EXPECT_EQ(test::rendered(std::move(build).finish(), {.width = 24, .height = 24}).bytes,
              empty.bytes);
  }
}

TEST(BadInput, AMillionPointsAtOnePlaceAreOne) {
  Polyline line{.points = std::vector<glm::dvec2>(1'000'000, {12, 12}), .half_width = 5};
  RenderStats stats;
  const View view{.width = 24, .height = 24};
  const Image image = test::rendered(only(line), view, {}, &stats);
  EXPECT_EQ(image.bytes, test::rendered(only(Disc{{12, 12}, 5}), view).bytes);
  EXPECT_LT(stats.pieces, 100);
  Path path;
  path.loops.push_back({std::vector<QuadBezier>(1'000'000, side({12, 12}, {12, 12}))});
  test::rendered(only(path), view, {}, &stats);
  EXPECT_EQ(stats.pieces, 0);
}

TEST(BadInput, AThousandCopiesOfAShapeAreDrawnOnce) {
  const View view{.width = 24, .height = 24};
  const TaperedStroke stroke{{{2, 2}, {20, 9}, {3, 20}}, {1, 2, 1}};
  const Path path{{{{side({2, 2}, {20, 5}), side({20, 5}, {9, 20}), side({9, 20}, {2, 2})}}}};
  for (const Shape& shape : {Shape(stroke), Shape(path), Shape(Disc{{12, 12}, 5})}) {
    SceneBuilder build = canvas(24);
    for (int i = 0; i < 1000; ++i) build.layer("copy", build.shape(shape), {kWhite});
    RenderStats once, many;
    const Image one = test::rendered(only(shape), view, {}, &once);
    EXPECT_EQ(test::rendered(std::move(build).finish(), view, {}, &many).bytes, one.bytes);
    EXPECT_EQ(many.pieces, once.pieces);
    EXPECT_EQ(many.crossings, once.crossings);
  }
}

/// Sides that go round and round a polygon.
Path rounds(int count, double radius, double grow) {
  constexpr int kCorners = 50;
  const auto at = [&](int i) {
    const double a = 2 * std::numbers::pi * (grow > 0 ? i : i % kCorners) / kCorners,
                 r = radius + grow * i;
    return glm::dvec2{12 + r * std::cos(a), 12 + r * std::sin(a)};
  };
  Path path;
  path.loops.emplace_back();
  for (int i = 0; i < count; ++i) path.loops[0].sides.push_back(side(at(i), at((i + 1) % count)));
  return path;
}

TEST(BadInput, PathsRoundAndRoundWorkByTheirPiecesAndCrossings) {
  const View view{.width = 24, .height = 24};
  RenderStats stats;
  test::rendered(only(rounds(times(100'000), 3, 8.0 / times(100'000))), view, {}, &stats);
  EXPECT_LE(stats.pieces, 110'000);
  EXPECT_LE(stats.crossings, 4 * stats.pieces);
  const Image once = test::rendered(only(rounds(50, 9, 0)), view);
  EXPECT_EQ(test::rendered(only(rounds(10'000, 9, 0)), view, {}, &stats).bytes, once.bytes);
  EXPECT_EQ(stats.doubts, 0);
}

TEST(BadInput, TanglesFansAndGridsAreRight) {
  Random r(1);
  Path tangle{.rule = FillRule::even_odd}, fan;
  tangle.loops.emplace_back();
  std::vector<glm::dvec2> corners(30);
  for (glm::dvec2& p : corners) p = r.point(1, 23);
  for (std::size_t i = 0; i < corners.size(); ++i)
    tangle.loops[0].sides.push_back(side(corners[i], corners[(i + 1) % corners.size()]));
  for (int i = 0; i < 40; ++i) {
    const double a = 2 * std::numbers::pi * i / 40, b = a + 0.08;
    const glm::dvec2 c{12, 12}, p = c + 11.0 * glm::dvec2{std::cos(a), std::sin(a)},
                                q = c + 11.0 * glm::dvec2{std::cos(b), std::sin(b)};
    fan.loops.push_back({{side(c, p), side(p, q), side(q, c)}});
  }
  expect_right(only(tangle));
  expect_right(only(fan));
  SceneBuilder build = canvas(24);
  for (int i = 0; i < 40; ++i) {
    const double x = 2 + 0.5 * i, y = x + 0.1;
    for (const bool upright : {false, true}) {
      const auto at = [&](double u, double v) {
        return upright ? glm::dvec2{u, v} : glm::dvec2{v, u};
      };
      build.layer("bar",
                  build.shape(Path{{{{side(at(x, 2), at(y, 2)), side(at(y, 2), at(y, 22)),
                                      side(at(y, 22), at(x, 22)), side(at(x, 22), at(x, 2))}}}}),
                  {{upright ? 1.0 : 0.2, 0.5, 0.7, 0.8}});
    }
  }
  expect_right(std::move(build).finish());
}

}  // namespace
}  // namespace mien::test
