// Light where it is likely to go wrong: feet on joints and axes, strokes wider than their spines are long, outlines that
// coincide, heights and widths of next to nothing, lamps at the horizon. Right pictures in bounded work.

#include <mien/render.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/exact/exact_windows.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

constexpr int kHostileSide = 16;  // [px] the canvas, one unit a pixel: its middle is that of a tile

struct HostileLight {
  Relief relief{.profile = Profile::round, .width = 3, .height = 2, .specular = 0.3};
  Light light{.direction = {-0.4, 0.6, 0.8}, .ambient = 0.3};
  Paint paint{.color = {0.6, 0.4, 0.3, 1}};

  /// `area` makes what it covers.
  template <class Make>
  Scene over(const Make& area) const {
    SceneBuilder build({.box = {{0, 0}, {kHostileSide, kHostileSide}}}, {0.2, 0.3, 0.4, 1});
    build.light(light);
    Relief own = relief;
    own.area = area(build);
    Paint with = paint;
    with.relief = shared(own);
    build.layer("hostile", own.area, with);
    return std::move(build).finish();
  }
  Scene over_shape(const Shape& shape) const {
    return over([&](SceneBuilder& build) { return build.shape(shape); });
  }
};

/// Some pixels of the exact picture are judged, in both blends and depths, and the work is bounded.
void expect_lit_right(const Scene& scene, const std::string& name, int every = 3,
                      const Wanted& wanted = kAllStorages) {
  SCOPED_TRACE(name);
  const View view{.width = kHostileSide, .height = kHostileSide, .dither = false};
  RenderStats stats;
  ASSERT_TRUE(render(scene, view, {.limits = {.steps = 2'000'000'000}}, &stats));
  const ExactTruth truth(scene, view, ExactTruth::kLit);
  Tallies tallies;
  judge_window(
      scene, view, {0, 0, kHostileSide, kHostileSide}, truth, wanted,
      [&](int x, int y) { return (3 * x + 5 * y) % every == 0; }, tallies);
  for (std::size_t i = 0; i < tallies.size(); ++i)
    EXPECT_EQ(tallies[i].over, 0) << kStorages[i].name << ": " << tallies[i].where;
}

QuadBezier edge(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

TEST(ExactHostileLight, FeetOnJointsAxesAndTileMiddlesAreRight) {
  const HostileLight lit;
  expect_lit_right(lit.over_shape(Path{{{{edge({8, 8}, {14, 2}), edge({14, 2}, {14.5, 14.5}),
                                          edge({14.5, 14.5}, {8, 8})}}}}),
                   "joint");
  expect_lit_right(lit.over_shape(Polyline{{{2, 8}, {8, 8}, {8, 14}}, 2.5}), "polyline");
  expect_lit_right(lit.over_shape(QuadStroke{{{2, 8}, {8, 8}, {14, 8}}, 3}), "axis");
  expect_lit_right(lit.over_shape(Ellipse{{8, 8}, {6, 6}}), "circle");
  expect_lit_right(lit.over_shape(Ellipse{{8, 8}, {7, 3}}), "ellipse");
  expect_lit_right(lit.over_shape(QuadStroke{{{3, 3}, {8, 17}, {13, 3}}, 2}), "parabola");
}

TEST(ExactHostileLight, StrokesWiderThanTheirSpinesAreLongAreRight) {
  const HostileLight lit;
  expect_lit_right(lit.over_shape(TaperedStroke{{{7, 8}, {8, 8}, {9, 8}}, {1, 4, 6}}), "outruns");
  expect_lit_right(lit.over_shape(TaperedStroke{{{6, 7}, {8, 12}, {10, 7}}, {0.5, 5, 3}}), "bent");
  expect_lit_right(lit.over_shape(QuadStroke{{{8, 8}, {8, 8}, {8, 8}}, 5}), "no spine");
  expect_lit_right(lit.over_shape(QuadStroke{{{5, 8}, {9, 8}, {6, 8}}, 3}), "turns back");
  expect_lit_right(lit.over_shape(TaperedStroke{{{5, 8}, {9, 8}, {6, 8}}, {1, 3, 3}}),
                   "turns and widens");
  expect_lit_right(lit.over_shape(TaperedStroke{{{5, 8}, {9, 8}, {5, 8}}, {1, 3, 1}}),
                   "turns where it is widest", 3, {true, false, true, false});
}

TEST(ExactHostileLight, BranchesThatCoincideAreRight) {
  const HostileLight lit;
  const Shape disc = Disc{{7.3, 8.1}, 5};
  expect_lit_right(lit.over([&](SceneBuilder& build) {
    return build.unite(build.shape(disc), build.shape(disc));
  }),
                   "twice");
  expect_lit_right(lit.over([&](SceneBuilder& build) {
    return build.intersect(build.shape(disc), build.shape(Ellipse{{7.3, 8.1}, {5, 5}}));
  }),
                   "both");
  expect_lit_right(lit.over([&](SceneBuilder& build) {
    return build.unite(build.shape(Line{{2, 8}, {10, 8}, 3}),
                       build.shape(Line{{6, 8}, {14, 8}, 3}));
  }),
                   "along each other");
}

TEST(ExactHostileLight, ReliefsOfNextToNothingAreRight) {
  for (const double height : {0.0, 1e-9, 2.0})
    for (const double width : {1e-9, 3.0}) {
      HostileLight lit;
      lit.relief.height = height, lit.relief.width = width;
      expect_lit_right(lit.over_shape(Ellipse{{8.2, 7.9}, {6, 4}}),
                       std::to_string(height) + " by " + std::to_string(width), 5);
    }
}

TEST(ExactHostileLight, LampsAtTheHorizonAndAllHighlightsAreRight) {
  for (const glm::dvec3 way :
       {glm::dvec3{1, 0, 0}, {1, 0, 1e-9}, {0, 1, 0.02}, {0, 0, 0}, {0.3, 0.2, -1}})
    for (const double shininess : {0.0, 1.0, 1e4}) {
      HostileLight lit;
      lit.light.direction = way, lit.relief.shininess = shininess, lit.relief.specular = 1;
      expect_lit_right(lit.over_shape(Ellipse{{8.2, 7.9}, {6, 4}}),
                       std::to_string(way.z) + ", " + std::to_string(shininess), 5);
    }
}

Scene with_stops(const std::vector<Stop>& stops) {
  HostileLight lit;
  return lit.over([&](SceneBuilder& build) {
    const Area area = build.shape(Disc{{8, 8}, 6});
    lit.paint.gradient = shared(Gradient{.along = DistanceGradient{area, -6, 0}, .stops = stops});
    return area;
  });
}

/// Stops that are nowhere are none, and places do not fall.
TEST(ExactHostileLight, StopsInAnyOrderAreRight) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto& places :
       {std::vector<double>{1, 0}, {0.5, 0.5}, {0.7, 0.2, 0.2, 0.9}, {0, none, 1}}) {
    std::vector<Stop> given, meant;
    double held = 0;
    for (const double place : places) {
      given.push_back({place, {given.size() % 2 ? 0.9 : 0.1, 0.4, 0.3, 1}});
      if (std::isnan(place)) continue;
      held = std::max(held, place);
      meant.push_back({held, given.back().color});
    }
    const View view{.width = kHostileSide, .height = kHostileSide};
    EXPECT_TRUE(rendered(with_stops(given), view).bytes == rendered(with_stops(meant), view).bytes);
    expect_lit_right(with_stops(meant), "stops from " + std::to_string(places[0]), 5);
  }
  EXPECT_TRUE(render(with_stops({{none, {1, 1, 1, 1}}}), {.width = 4, .height = 4}));
}

TEST(ExactHostileLight, HundredsOfReliefsAndShapesAreRight) {
  Random random(8);
  SceneBuilder build({.box = {{0, 0}, {kHostileSide, kHostileSide}}}, {0.2, 0.3, 0.4, 1});
  build.light({.direction = {-0.4, 0.6, 0.8}, .ambient = 0.3});
  for (int i = 0; i < 100; ++i) {
    const Area area = build.shape(Disc{random.point(4, 12), random.between(2, 5)});
    const Relief relief{.area = area, .profile = Profile::bevel, .width = 2, .height = 1};
    build.layer("one", area, {.color = {0.6, 0.4, 0.3, i % 2 ? 1 : 0.5}, .relief = shared(relief)});
  }
  expect_lit_right(std::move(build).finish(), "a hundred reliefs", 41);
  const HostileLight lit;
  expect_lit_right(lit.over([&](SceneBuilder& of) {
    Area all = of.shape(Disc{random.point(2, 14), 0.5});
    for (int i = 1; i < 300; ++i)
      all = of.unite(all, of.shape(Disc{random.point(2, 14), random.between(0.2, 0.8)}));
    return all;
  }),
                   "a union of 300", 127);
}

}  // namespace
}  // namespace mien::test
