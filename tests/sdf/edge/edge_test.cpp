// What edges_near says against what the shape's distance says: the description may be wrong by its
// stated error, never by more, and for shapes that are large against the disc it must be proven, or
// nothing would be fast.

#include <mien/sdf/edge/edge.h>
#include <mien/sdf/shape/quad_bezier.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

namespace mien {
namespace {

double value(const Edge& e, glm::dvec2 u) {
  const double along = u.y * e.normal.x - u.x * e.normal.y;
  return e.d + glm::dot(u, e.normal) + 0.5 * e.bend * along * along;
}

/// Inside by the description, at c + u.
bool described_inside(const LocalOutline& o, const std::vector<Edge>& edges, glm::dvec2 u) {
  bool all = true, any = false;
  int winding = o.winding;
  for (int i = o.first; i < o.first + o.count; ++i) {
    const Edge& e = edges[std::size_t(i)];
    const bool in = value(e, u) <= 0;
    all &= in, any |= in;
    if (in) winding += e.turn;
  }
  switch (o.rule) {
    case EdgeRule::outside:
      return false;
    case EdgeRule::inside:
      return true;
    case EdgeRule::all:
      return all;
    case EdgeRule::any:
      return any;
    case EdgeRule::nonzero:
      return winding != 0;
    case EdgeRule::even_odd:
      return winding % 2 != 0;
  }
  return false;
}

struct Tally {
  int discs = 0, proven = 0;
};

/// Looks at `count` discs whose centres lie near the outline of the shape.
Tally check(const OffsetShape& shape, double radius, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-120, 120), unit(-1, 1);
  Tally tally;
  std::vector<Edge> edges;
  for (int tries = 0; tally.discs < count && tries < 400 * count; ++tries) {
    glm::dvec2 c{place(random), place(random)};
    double d = distance(shape, c);
    for (int step = 0; step < 8 && std::abs(d) > radius; ++step) {  // walk to the outline
      const double h = 1e-4;
      const glm::dvec2 g{
          distance(shape, c + glm::dvec2{h, 0}) - distance(shape, c - glm::dvec2{h, 0}),
          distance(shape, c + glm::dvec2{0, h}) - distance(shape, c - glm::dvec2{0, h})};
      if (!(glm::length(g) > 0)) break;
      c -= d * g / (2 * h);
      d = distance(shape, c);
    }
    if (std::abs(d) > radius) continue;
    c += radius * glm::dvec2{unit(random), unit(random)};
    ++tally.discs;
    edges.clear();
    const LocalOutline o = edges_near(shape, c, radius, edges);
    if (o.error == kUnproven) continue;
    ++tally.proven;
    for (int k = 0; k < 48; ++k) {
      glm::dvec2 u{unit(random), unit(random)};
      if (glm::length(u) > 1) continue;
      u *= radius;
      const double truth = distance(shape, c + u);
      const double allowed = o.error + 1e-9;
      if (std::abs(truth) <= allowed) continue;
      EXPECT_EQ(described_inside(o, edges, u), truth < 0)
          << fmt::format("c {} {} radius {} u {} {}: distance {}, stated error {}, {} edges", c.x,
                         c.y, radius, u.x, u.y, truth, o.error, o.count);
    }
  }
  return tally;
}

struct Case {
  const char* name;
  OffsetShape shape;
  double proven;  ///< at least this share of the discs of 0.7 px, in [0, 1]
};

std::vector<Case> cases() {
  const QuadBezier arc{{-80, -30}, {10, 90}, {85, -40}}, hook{{-60, 0}, {80, 20}, {-60, 30}};
  const Path leaf{{{{{{-70, 0}, {0, 60}, {70, 0}}, {{70, 0}, {0, -40}, {-70, 0}}}}}};
  const Path star{{{{{{-60, -50}, {0, 45}, {60, -50}},
                     {{60, -50}, {-20, 10}, {-70, 40}},
                     {{-70, 40}, {0, 40}, {70, 40}},
                     {{70, 40}, {5, 0}, {-60, -50}}}}},
                  FillRule::even_odd};
  return {
      {"half plane", {HalfPlane{{0.6, 0.8}, 10}}, 1},
      {"parabola", {ParabolaSide{{3, -20}, {0, 1}, 0.01}}, 1},
      {"parabola from outside", {ParabolaSide{{3, -20}, {0.6, 0.8}, -0.02}}, 1},
      {"sharp parabola", {ParabolaSide{{3, -20}, {0, 1}, 2.0}}, 0.5},
      {"grown parabola", {ParabolaSide{{3, -20}, {0, 1}, 0.01}, 7.5}, 0.9},
      {"disc", {Disc{{5, 5}, 40}}, 1},
      {"small disc", {Disc{{5, 5}, 1}}, 0},
      {"ellipse", {Ellipse{{0, 0}, {60, 40}}}, 1},
      {"turned ellipse", {Ellipse{{0, 0}, {70, 30}, {0.8, 0.6}}}, 1},
      {"flat ellipse", {Ellipse{{0, 0}, {70, 3}}}, 0},
      {"line", {Line{{-50, -20}, {60, 30}, 8}}, 0.8},
      {"thin line", {Line{{-50, -20}, {60, 30}, 0.2}}, 0.5},
      {"stroke", {QuadStroke{arc, 6}}, 0.7},
      {"thin stroke", {QuadStroke{arc, 0.3}}, 0.7},
      {"fat stroke", {QuadStroke{arc, 45}}, 0.4},
      {"hook", {QuadStroke{hook, 9}}, 0.4},
      {"tapered stroke", {TaperedStroke{arc, {3, 14, 5}}}, 0.6},
      {"swelling stroke", {TaperedStroke{hook, {2, 16, 1}}}, 0.05},
      {"pointed stroke", {TaperedStroke{arc, {0, 9, 0}}}, 0.3},
      {"tapered, grown", {TaperedStroke{arc, {3, 14, 5}}, 2.5}, 0.6},
      {"leaf", {leaf}, 0.85},
      {"star", {star}, 0.55},
  };
}

TEST(EdgesNear, AreWithinTheirStatedErrorOfTheDistance) {
  for (const Case& c : cases())
    for (const double radius : {0.7, 0.1, 3.0}) {
      SCOPED_TRACE(fmt::format("{}, radius {}", c.name, radius));
      const Tally tally = check(c.shape, radius, 600, 7);
      ASSERT_GT(tally.discs, 300);
      const double share = double(tally.proven) / tally.discs;
      EXPECT_TRUE(radius != 0.7 || share >= c.proven) << share << " proven";
    }
}

TEST(EdgesNear, ErrorsShrinkWithTheDisc) {
  std::vector<Edge> edges;
  const OffsetShape stroke{QuadStroke{{{-80, -30}, {10, 90}, {85, -40}}, 6}};
  const NearestPoint top = {0, 0.5, {6.25, 27.5}};
  double last = 1;
  for (const double radius : {1.0, 0.5, 0.25, 0.125}) {
    edges.clear();
    const LocalOutline o = edges_near(stroke, top.point + glm::dvec2{0, 6}, radius, edges);
    ASSERT_EQ(o.count, 1);
    EXPECT_LT(o.error, last / 4);  // third order, with room for second
    last = o.error;
  }
}

TEST(EdgesNear, SeesBothSidesOfAThinLine) {
  std::vector<Edge> edges;
  const LocalOutline o = edges_near({Line{{-9, 0}, {9, 0}, 0.01}}, {0, 0.2}, 0.7, edges);
  EXPECT_EQ(o.rule, EdgeRule::all);
  EXPECT_EQ(o.count, 2);
  EXPECT_EQ(o.error, 0);
}

}  // namespace
}  // namespace mien
