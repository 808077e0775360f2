// Outlines of strokes: few pieces, and spines that bend tightly.

#include <gtest/gtest.h>

#include <mien/scene.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sdf/outline/outline_maker.h"

#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"
#include "tests/support/shapes/drawn_outline.h"

namespace mien::test {
namespace {

/// Pieces are what the sweep pays for.
TEST(StrokeOutline, GentleStrokesTakeFewPieces) {
  const QuadBezier arch{{2, 60}, {32, 20}, {62, 60}};
  EXPECT_LT(DrawnOutline::fill(QuadStroke{arch, 3}, {}).outlines.pieces.size(), 40u);
  EXPECT_LT(DrawnOutline::fill(TaperedStroke{arch, {0, 4, 0}}, {}).outlines.pieces.size(), 28u);
  EXPECT_LT(DrawnOutline::fill(Disc{{32, 32}, 20}, {}).outlines.pieces.size(), 21u);
}

/// Spines that all but turn back, or end with all but no speed: rims are arcs there, in no time at all.
TEST(StrokeOutline, StrokesMayBendAsTightlyAsTheyLike) {
  Random r(11);
  for (int i = 0; i < times(2000); ++i) {
    const double tiny = r.size(-12, -1), loose = r.size(-12, -1);
    const auto shaken = [&](glm::dvec2 p, double by) { return p + by * r.point(-1, 1); };
    const glm::dvec2 way = r.direction(), p0 = r.point(-0.6, 0.6), p1 = shaken(p0 + way, tiny);
    const double back = r.chance(0.5) ? 1.0 : r.between(0.2, 0.8);  // ends at p1, or turns back
    const double w = 0.1 + 0.1 * r.unit();
    const TaperedStroke stroke{{p0, p1, shaken(p0 + back * way, tiny)},
                               {w, w + loose * r.between(-1, 1), w + loose * r.between(-1, 1)}};
    const DrawnOutline d = DrawnOutline::fill(stroke, upright(1));
    for (int k = 0; k < 60; ++k) {
      const glm::dvec2 p = d.place(r);
      const double distance = d.distance(stroke, p);
      // Where a rim and a cap run back along each other they are as far apart as either may be off.
      bool right =
          std::abs(distance) < kOutlineTolerance + kOutlineSnap || d.inside(p) == (distance < 0);
      for (const glm::dvec2 off : {glm::dvec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        right = right || d.inside(p + 3 * kOutlineTolerance * off) == (distance < 0);
      ASSERT_TRUE(right) << i << ", " << tiny << ", " << loose << ": " << distance;
    }
  }
}

/// Strokes of all kinds: gentle ones, hairpins, widths that outrun the spine, points of no width, no length.
TaperedStroke any_stroke(Random& r) {
  const double size = r.size(-3, 0);
  QuadBezier spine{size * r.point(-1, 1), size * r.point(-1, 1), size * r.point(-1, 1)};
  if (r.chance(0.2)) spine.p2 = spine.p0 + r.size(-6, -2) * r.point(-1, 1);
  if (r.chance(0.05)) spine.p1 = spine.p2 = spine.p0;
  const auto width = [&] { return r.chance(0.2) ? 0.0 : 0.4 * size * r.unit() * r.unit(); };
  return {spine, {width(), r.chance(0.2) ? 0.0 : 2 * width(), width()}};
}

/// What is hidden, inside on both hands, may lie anywhere.
TEST(StrokeOutline, NoPieceLeavesTheRimByMoreThanTheTolerance) {
  Random r(37);
  double worst = 0;
  for (int i = 0; i < times(1500); ++i) {
    const TaperedStroke stroke = any_stroke(r);
    const DrawnOutline d = DrawnOutline::fill(stroke, upright(1));
    for (const OutlinePiece& piece : d.outlines.pieces)
      for (int k = 1; k < 8; ++k) {
        const glm::dvec2 p = point(piece, k / 8.0);
        if (!kOutlineWindow.contains(p)) continue;
        const double far = std::abs(d.distance(stroke, p));
        if (far <= kOutlineTolerance + kOutlineSnap) {
          worst = std::max(worst, far);
          continue;
        }
        const glm::dvec2 way{piece.y1 - piece.y0, piece.x0 - piece.x1};
        const glm::dvec2 off = 1e-4 / glm::length(way) * way;
        ASSERT_TRUE(d.inside(p + off) && d.inside(p - off)) << i << ": " << far;
      }
  }
  EXPECT_GT(worst, 0.8 * kOutlineTolerance);
}

/// Where it counts, a rim is as many pieces as the fourth root of its error asks for: the radius of its bend, as a
/// function of the normal's angle, tells it. docs/derivations/outlines.md
TEST(StrokeOutline, TakesAsManyPiecesAsTheErrorAsksFor) {
  Random r(5);
  const auto cross_of = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
  for (int i = 0; i < 40; ++i) {
    const QuadBezier spine{{-300, 0}, {r.between(-60, 60), r.between(60, 300)}, {300, 0}};
    const double w[3] = {r.between(2, 9), r.between(4, 30), r.between(2, 9)};
    constexpr double kTolerance = 1e-5;
    Outlines outlines;
    OutlineMaker maker;
    maker.begin({{}, {{-1e4, -1e4}, {1e4, 1e4}}, kTolerance}, outlines);
    maker.fill(TaperedStroke{spine, {w[0], w[1], w[2]}});
    maker.finish();
    const glm::dvec2 a = spine.p1 - spine.p0, b = spine.p2 - spine.p1 - a;
    const double wa = w[1] - w[0], wb = w[2] - w[1] - wa;
    double wanted = 0;
    for (const double side : {-1.0, 1.0}) {
      // From its normals at the ends, by the angle.
      const auto angle_at = [&](double t) {
        const glm::dvec2 v = 2.0 * (a + t * b), ahead = v / glm::length(v);
        const double lean = 2.0 * (wa + t * wb) / glm::length(v),
                     across = side * std::sqrt(1 - lean * lean);
        const glm::dvec2 n = across * glm::dvec2{-ahead.y, ahead.x} - lean * ahead;
        return std::atan2(n.y, n.x);
      };
      const auto radius = [&](double angle) {
        const glm::dvec2 n{std::cos(angle), std::sin(angle)};
        const double bend = glm::dot(b, n) + wb, t = -(glm::dot(a, n) + wa) / bend;
        const double u = cross_of(n, 2.0 * (a + t * b));
        return w[0] + t * (2 * wa + t * wb) - u * u / (2 * bend);
      };
      const double from = angle_at(0),
                   turn = std::remainder(angle_at(1) - from, 2 * 3.141592653589793);
      constexpr int kSteps = 2000;
      for (int k = 0; k < kSteps; ++k) {
        const double h = 1e-4, at = from + (k + 0.5) / kSteps * turn;
        const double rho = radius(at), up = radius(at + h), down = radius(at - h);
        const double one = (up - down) / (2 * h), two = (up - 2 * rho + down) / (h * h);
        const double error =
            std::abs(9 * rho * rho + 4 * one * one - 3 * rho * two) / (1152 * std::abs(rho));
        wanted += std::pow(error / kTolerance, 0.25) * std::abs(turn) / kSteps;
      }
    }
    // Two round ends are some forty pieces.
    double ends = 0;
    for (const double radius : {w[0], w[2]})
      ends += 3.2 * std::pow(0.56 * radius / (128 * kTolerance), 0.25);
    const double count = double(outlines.pieces.size()) - ends;
    EXPECT_LT(count, 1.15 * wanted + 12) << i;
    EXPECT_GT(count, 0.9 * wanted - 6) << i;
  }
}

/// What a row of strokes covers is what they cover one by one, in fewer pieces where they go on as each other.
TEST(StrokeOutline, ARowOfStrokesIsTheirUnion) {
  Random r(8);
  for (int i = 0; i < times(300); ++i) {
    SceneBuilder build({}, {});
    std::vector<TaperedStroke> strokes;
    glm::dvec2 at = r.point(-0.8, 0.8), bend = at + 0.3 * r.point(-1, 1);
    const double w = 0.01 + 0.1 * r.unit();
    const bool smooth = r.chance(0.6);
    Area all;
    for (int k = 2 + r.below(70); k > 0; --k) {
      const glm::dvec2 next = smooth ? 2.0 * at - bend : at + 0.3 * r.point(-1, 1);
      bend = strokes.empty() ? bend : next;
      const glm::dvec2 to = 0.5 * (bend + bend + 0.2 * r.point(-1, 1));
      strokes.push_back({{at, bend, to}, {w, w, w}});
      const Area one = build.shape(strokes.back());
      all = strokes.size() == 1 ? one : build.unite(all, one);
      at = to;
    }
    const double level = r.chance(0.5) ? 0.0 : r.between(-0.02, 0.05);
    build.layer("row", all, {});
    const Scene scene = std::move(build).finish();
    AreaPrograms programs;
    programs.begin(scene);
    programs.add(all, level);
    ASSERT_EQ(programs.outlines().size(), 1u);
    DrawnOutline d = DrawnOutline::fill(strokes[0], upright(1));
    OutlineMaker maker;
    maker.begin({upright(1), kOutlineWindow, kOutlineTolerance}, d.outlines);
    maker.add(programs, programs.outlines()[0]);
    maker.finish();
    for (int k = 0; k < 200; ++k) {
      const glm::dvec2 p = d.place(r);
      double far = HUGE_VAL;
      for (const TaperedStroke& stroke : strokes) far = std::min(far, d.distance(stroke, p));
      far -= level * upright(1).scale();
      if (std::abs(far) <= kOutlineTolerance + kOutlineSnap) continue;
      ASSERT_EQ(d.inside(p), far < 0) << i << ": " << far;
    }
  }
}

}  // namespace
}  // namespace mien::test
