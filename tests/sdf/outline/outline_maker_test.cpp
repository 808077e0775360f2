// Outlines of every shape against its distance.

#include "sdf/outline/outline_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_shapes.h"
#include "tests/support/shapes/drawn_outline.h"
#include "tests/support/shapes/shape_examples/all.h"

namespace mien::test {
namespace {

/// The area that the loops wind around, by Green: exact for quadratic pieces.
double area(const Outlines& o) {
  double sum = 0;
  for (const OutlineEnd& e : o.ends)  // where the loop runs along a side
    if (e.other < 0) sum += e.x * e.y * (e.begins ? -1 : 1) * o.chains[std::size_t(e.chain)].turn;
  for (const OutlinePiece& p : o.pieces) {
    // ∫ x dy = Σ over x = x0 + 2 ax t + bx t², dy = (2 ay + 2 by t) dt.
    const double along =
        p.x0 * (p.y1 - p.y0) + 2 * p.ax * (p.ay + 2 * p.by / 3) + 2 * p.bx * (p.ay / 3 + p.by / 4);
    sum -= chain_of(o, p).turn * along;
  }
  return std::abs(sum);
}

/// The window's share within the shape, by the distance at the centres of small squares.
double area_by_distance(const DrawnOutline& d, const Shape& shape) {
  constexpr int kSteps = 640;
  const double h = 64.0 / kSteps;
  double sum = 0;
  for (int y = 0; y < kSteps; ++y)
    for (int x = 0; x < kSteps; ++x)
      sum += std::clamp(0.5 - d.distance(shape, {(x + 0.5) * h, (y + 0.5) * h}) / h, 0.0, 1.0);
  return sum * h * h;
}

template <class S>
class OutlineLaws : public testing::Test {
 protected:
  Random random{11};
};
TYPED_TEST_SUITE(OutlineLaws, OutlinedShapes);

TYPED_TEST(OutlineLaws, PiecesAreInOrder) {
  for (const auto& e : examples<TypeParam>()) {
    expect_in_order(DrawnOutline::fill(e.shape, upright(e.size)).outlines);
    expect_in_order(DrawnOutline::rim(e.shape, 0.05 * e.size, upright(e.size)).outlines);
  }
}

TYPED_TEST(OutlineLaws, WindAroundTheInside) {
  for (const auto& e : examples<TypeParam>()) {
    const DrawnOutline d = DrawnOutline::fill(e.shape, upright(e.size));
    for (int i = 0; i < times(4'000); ++i) {
      const glm::dvec2 p = d.place(this->random);
      const double far = d.distance(e.shape, p);
      if (std::abs(far) <= kOutlineTolerance + kOutlineSnap) continue;
      EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far;
    }
  }
}

/// Unless hidden: inside on both hands.
TYPED_TEST(OutlineLaws, LieOnTheOutlineToTheTolerance) {
  int seen = 0;
  for (const auto& e : examples<TypeParam>()) {
    const DrawnOutline d = DrawnOutline::fill(e.shape, upright(e.size));
    for (const OutlinePiece& piece : d.outlines.pieces)
      for (int i = 1; i < 16; ++i) {
        const glm::dvec2 p = point(piece, i / 16.0);
        if (!kOutlineWindow.contains(p)) continue;
        const double far = d.distance(e.shape, p);
        ++seen;
        if (std::abs(far) <= kOutlineTolerance + kOutlineSnap) continue;
        const glm::dvec2 way{piece.y1 - piece.y0, piece.x0 - piece.x1};
        const glm::dvec2 off = 1e-4 / glm::length(way) * way;
        EXPECT_TRUE(d.inside(p + off) && d.inside(p - off)) << p.x << ' ' << p.y << " d " << far;
      }
  }
  EXPECT_GT(seen, 20);
}

TYPED_TEST(OutlineLaws, EncloseTheArea) {
  for (const auto& e : examples<TypeParam>()) {
    const DrawnOutline d = DrawnOutline::fill(e.shape, upright(e.size));
    const Box2 box = bounds(Shape(e.shape));
    if (e.hollow || box.empty() ||
        !Box2{glm::dvec2(-e.size), glm::dvec2(e.size)}.contains(box.lo) ||
        !Box2{glm::dvec2(-e.size), glm::dvec2(e.size)}.contains(box.hi) ||
        overlaps_itself(d, this->random))
      continue;
    const Shape shape = e.shape;
    if (std::holds_alternative<Path>(shape) && std::get<Path>(shape).loops.size() > 1) continue;
    EXPECT_NEAR(area(d.outlines), area_by_distance(d, shape), 0.2);
  }
}

/// A window on a part of the shape sees what the whole one is, at any size, and in few pieces.
TYPED_TEST(OutlineLaws, AreRightInAnyWindow) {
  for (const auto& e : examples<TypeParam>())
    for (int k = 0; k < times(60); ++k) {
      const double size = e.size / this->random.size(0, 6);
      auto map = upright(size);
      glm::dvec2 focus = this->random.point(-e.size, e.size);
      for (int step = 0; step < 6; ++step) {  // to the outline, if the distance leads there
        const double h = 1e-6, f = distance(e.shape, focus);
        const glm::dvec2 g{distance(e.shape, focus + glm::dvec2(h, 0)) - f,
                           distance(e.shape, focus + glm::dvec2(0, h)) - f};
        if (!(glm::length(g) > 0.5 * h) || !std::isfinite(f)) break;
        focus -= f / glm::length(g) * g;
      }
      map.shift -= map.direction(focus);
      map.shift += 40.0 * this->random.point(-1, 1);
      const DrawnOutline d = DrawnOutline::fill(e.shape, map);
      EXPECT_LT(d.outlines.pieces.size(), 4000u);
      const double noise = kOutlineTolerance + kOutlineSnap + 1e-13 * map.scale() * e.size;
      for (int i = 0; i < 40; ++i) {
        const glm::dvec2 p = d.place(this->random);
        const double far = d.distance(e.shape, p);
        if (!(std::abs(far) > noise)) continue;
        EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far << " size " << size;
      }
    }
}

TYPED_TEST(OutlineLaws, RunBackwardsOrMirroredTheyEncloseTheSame) {
  for (const auto& e : examples<TypeParam>()) {
    const auto map = upright(e.size);
    auto mirror = map;
    mirror.linear[0].x *= -1;
    const DrawnOutline d = DrawnOutline::fill(e.shape, map),
                       mirrored = DrawnOutline::fill(e.shape, mirror);
    const DrawnOutline back = DrawnOutline::fill(backwards(e.shape), map);
    for (int i = 0; i < times(1'000); ++i) {
      const glm::dvec2 p = d.place(this->random);
      if (std::abs(d.distance(e.shape, p)) <= kOutlineTolerance + kOutlineSnap) continue;
      EXPECT_EQ(back.inside(p), d.inside(p)) << p.x << ' ' << p.y;
      EXPECT_EQ(mirrored.inside({64 - p.x, p.y}), d.inside(p)) << p.x << ' ' << p.y;
    }
  }
}

/// Circles and their arcs enclose their own area, not only to the tolerance.
TEST(OutlineMaker, ArcsAreTrueInArea) {
  for (const double radius : {0.3, 3.0, 29.0}) {
    const DrawnOutline disc = DrawnOutline::fill(Disc{{32, 32}, radius}, {});
    EXPECT_NEAR(area(disc.outlines), 3.141592653589793 * radius * radius,
                0.05 * kOutlineTolerance * 6.28 * radius);
    const DrawnOutline line = DrawnOutline::fill(Line{{32, 31}, {32, 32}, radius}, {});
    EXPECT_NEAR(area(line.outlines), (3.141592653589793 * radius + 2) * radius,
                0.05 * kOutlineTolerance * 6.28 * radius);
  }
}

TEST(OutlineMaker, AnyShapeIsFilledWhereItsDistanceIsNegative) {
  RandomShapes shapes(5);
  for (int k = 0; k < times(6'000); ++k) {
    const Shape shape = shapes.next();
    const DrawnOutline d = DrawnOutline::fill(shape, {});
    for (int i = 0; i < 30; ++i) {
      const glm::dvec2 p = d.place(shapes.r);
      const double far = d.distance(shape, p);
      if (!(std::abs(far) > kOutlineTolerance + kOutlineSnap)) continue;
      EXPECT_EQ(d.inside(p), far < 0)
          << shape_name(shape) << " " << k << ": " << p.x << ' ' << p.y << " d " << far;
    }
  }
}

/// Some coordinates are far outside: to 10⁹ px beside 64.
TEST(OutlineMaker, ShapesMayBeMuchLargerThanTheWindow) {
  RandomShapes shapes(7);
  Random& r = shapes.r;
  for (int k = 0; k < times(2'000); ++k) {
    const double scale = r.size(1, 7);
    Shape shape =
        transformed({scale, 0, 0, scale}, -scale * r.point(0, 64) + r.point(0, 64), shapes.next());
    if (auto* path = std::get_if<Path>(&shape))
      for (auto& side : path->loops[0].sides)
        if (r.chance(0.3)) side.p1 = r.point(-64, 128);
    if (auto* stroke = std::get_if<QuadStroke>(&shape)) {
      if (r.chance(0.5)) stroke->half_width = r.between(0, 20);
      if (r.chance(0.5)) stroke->spine.p1 = r.point(0, 64);
    }
    const DrawnOutline d = DrawnOutline::fill(shape, {});
    EXPECT_LT(d.outlines.pieces.size(), 5000u) << shape_name(shape);
    const double noise = kOutlineTolerance + kOutlineSnap + 1e-13 * 100 * scale;
    for (int i = 0; i < 30; ++i) {
      const glm::dvec2 p = d.place(r);
      const double far = d.distance(shape, p);
      if (!(std::abs(far) > noise)) continue;
      EXPECT_EQ(d.inside(p), far < 0) << shape_name(shape) << " " << k << ": " << p.x << ' ' << p.y
                                      << " d " << far << " scale " << scale;
    }
  }
}

TEST(OutlineMaker, BeyondTheWindowThereIsNothing) {
  for (const glm::dvec2 shift : {glm::dvec2(100, 0), glm::dvec2(-100, 0), glm::dvec2(0, 100),
                                 glm::dvec2(0, -100), glm::dvec2(1e12, 1e12)}) {
    for (const Shape& shape :
         {Shape(Disc{{32, 32}, 20}), Shape(Ellipse{{32, 32}, {20, 10}}),
          Shape(Line{{30, 20}, {40, 50}, 10}), Shape(QuadStroke{{{20, 20}, {30, 60}, {50, 30}}, 5}),
          Shape(Triangle{{10, 10}, {50, 20}, {30, 50}})}) {
      EXPECT_FALSE(DrawnOutline::fill(shape, {}).outlines.pieces.empty());
      EXPECT_TRUE(DrawnOutline::fill(transformed(glm::dmat2(1.0), shift, shape), {})
                      .outlines.pieces.empty());
    }
  }
}

TEST(OutlineMaker, WhatIsNoNumberIsNotDrawn) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e300, -1e300})
    for (const Shape& shape :
         {Shape(HalfPlane{{0, 1}, bad}), Shape(ParabolaSide{{bad, 0}, {0, 1}, 1}),
          Shape(ParabolaSide{{0, 0}, {0, 1}, bad}),
          Shape(Band{{{0, bad}, {0, 1}, 1}, {{0, 0}, {0, -1}, 1}}), Shape(Disc{{bad, 0}, 1}),
          Shape(Disc{{0, 0}, bad}), Shape(CutDisc{{0, bad}, 1, 0.5, 0.5, {0, 1}}),
          Shape(Ellipse{{0, 0}, {bad, 1}, {1, 0}}), Shape(Triangle{{0, 0}, {bad, 1}, {1, 0}}),
          Shape(Line{{0, 0}, {bad, 1}, 1}), Shape(Line{{0, 0}, {1, 1}, bad}),
          Shape(Polyline{{{0, 0}, {1, bad}, {4, 4}}, 1}),
          Shape(QuadStroke{{{0, 0}, {bad, 1}, {9, 9}}, 1}),
          Shape(TaperedStroke{{{0, 0}, {4, 1}, {9, 9}}, {1, bad, 1}}),
          Shape(Path{{{{{{0, 0}, {bad, 1}, {9, 9}}}}}, FillRule::nonzero})}) {
      const DrawnOutline fill = DrawnOutline::fill(shape, {}),
                         rim = DrawnOutline::rim(shape, 2.0, {});
      expect_in_order(fill.outlines);
      expect_in_order(rim.outlines);
      for (const OutlinePiece& p : fill.outlines.pieces)
        EXPECT_TRUE(std::isfinite(p.ax + p.ay + p.bx + p.by)) << shape_name(shape);
    }
  expect_in_order(DrawnOutline::rim(Disc{{8, 8}, 4}, nan, {}).outlines);
  expect_in_order(DrawnOutline::rim(Disc{{8, 8}, 4}, inf, {}).outlines);
}

TEST(OutlineMaker, ManyPointsAndSidesTakeTheirTimeOnly) {
  Polyline still{std::vector<glm::dvec2>(1'000'000, {20, 20}), 5};
  EXPECT_LT(DrawnOutline::fill(still, {}).outlines.pieces.size(), 40u);
  still.points.push_back({40, 30});
  EXPECT_LT(DrawnOutline::fill(still, {}).outlines.pieces.size(), 40u);
  Random r(3);
  Path path;
  Path::Loop& loop = path.loops.emplace_back();
  for (int i = 0; i < 100'000; ++i) {
    const double angle = 6.283185307179586 * i / 100'000;
    const glm::dvec2 p =
        glm::dvec2(32, 32) + r.between(19, 20) * glm::dvec2(std::cos(angle), std::sin(angle));
    const glm::dvec2 from = loop.sides.empty() ? p : loop.sides.back().p2;
    loop.sides.push_back({from, 0.5 * (from + p), p});
  }
  const DrawnOutline d = DrawnOutline::fill(path, {});
  EXPECT_LE(d.outlines.pieces.size(), 100'001u);
  EXPECT_TRUE(d.inside({32, 32}));
  // Far to the left they are one line along the border.
  const DrawnOutline far = DrawnOutline::fill(path, {{100, 0, 0, 100}, {-4000, -3100}});
  EXPECT_LT(far.outlines.pieces.size(), 20'000u);
}

}  // namespace
}  // namespace mien::test
