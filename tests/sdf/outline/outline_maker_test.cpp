// Outlines of every shape against its distance. Longer than other files: the scenes that once failed stand beside
// the laws they broke, and all of them share one way to ask.

#include "sdf/outline/outline_maker.h"
#include "sdf/shape/curve/band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/support/effort.h"
#include "tests/support/outline_sight.h"
#include "tests/support/random.h"
#include "tests/support/shape_examples/all.h"

namespace mien::test {
namespace {

constexpr double kTolerance = 1.0 / 800;
/// Rounding of vertices, and of the distance.
constexpr double kSnap = 4e-6;
const Box2 kMadeWindow{{0, 0}, {64, 64}};

/// (−size, size)² on the window, y up.
Map<GridSpace, FaceSpace> upright(double size) {
  const double k = 32 / size;
  return {{k, 0, 0, -k}, {32, 32}};
}

struct Drawn {
  Outlines outlines;
  Map<GridSpace, FaceSpace> map;
  Map<FaceSpace, GridSpace> back;

  explicit Drawn(const Map<GridSpace, FaceSpace>& m) : map(m), back(inverse(m)) {}

  static Drawn fill(const Shape& shape, const Map<GridSpace, FaceSpace>& map,
                    const Box2& window = kMadeWindow) {
    Drawn d(map);
    OutlineMaker maker;
    maker.begin({map, window, kTolerance}, d.outlines);
    EXPECT_EQ(maker.fill(shape), 0);
    maker.finish();
    return d;
  }
  static Drawn rim(const Shape& shape, double width, const Map<GridSpace, FaceSpace>& map) {
    Drawn d(map);
    OutlineMaker maker;
    maker.begin({map, kMadeWindow, kTolerance}, d.outlines);
    EXPECT_EQ(maker.rim(shape, width), 0);
    maker.finish();
    return d;
  }

  bool inside(glm::dvec2 p) const { return is_inside(outlines, 0, p); }
  /// [px]
  double distance(const Shape& shape, glm::dvec2 p) const {
    return map.scale() * mien::distance(shape, back(p));
  }

  /// A point of the window; every second one near a piece.
  glm::dvec2 place(Random& r, const Box2& window = kMadeWindow) const {
    if (!outlines.pieces.empty() && r.chance(0.5)) {
      const OutlinePiece& piece = outlines.pieces[r.below(int(outlines.pieces.size()))];
      const glm::dvec2 p = point(piece, r.unit()) + r.size(-2.6, 1) * r.direction();
      if (window.contains(p)) return p;
    }
    const double x = r.between(window.lo.x, window.hi.x);
    return {x, r.between(window.lo.y, window.hi.y)};
  }
};

/// Whether two pieces of it lie over each other, so that winding numbers exceed 1.
bool overlaps_itself(const Drawn& d, Random& r) {
  for (int i = 0; i < 400; ++i)
    if (std::abs(winding(d.outlines, 0, d.place(r))) > 1) return true;
  return false;
}

void expect_in_order(const Outlines& o) {
  const auto on_grid = [](double v) { return std::ldexp(v, 20) == std::round(std::ldexp(v, 20)); };
  for (std::size_t i = 0; i < o.vertices.size(); ++i) {
    const OutlineVertex& v = o.vertices[i];
    EXPECT_TRUE(on_grid(v.x) && on_grid(v.y));
    ASSERT_TRUE(v.in >= 0 && v.out >= 0 && v.in != v.out);
    const OutlinePiece &in = o.pieces[v.in], &out = o.pieces[v.out];
    EXPECT_EQ(in.turn > 0 ? in.bottom : in.top, int(i));
    EXPECT_EQ(out.turn > 0 ? out.top : out.bottom, int(i));
    EXPECT_EQ(in.outline, out.outline);
  }
  ASSERT_EQ(o.vertices.size(), o.pieces.size());
  for (const OutlinePiece& p : o.pieces) {
    const OutlineVertex &top = o.vertices[p.top], &bottom = o.vertices[p.bottom];
    EXPECT_TRUE(p.x0 == top.x && p.y0 == top.y && p.x1 == bottom.x && p.y1 == bottom.y);
    EXPECT_TRUE(p.y0 < p.y1 || (p.y0 == p.y1 && p.x0 < p.x1));
    EXPECT_TRUE(p.turn == 1 || p.turn == -1);
    const double x = p.x0 + p.ax, y = p.y0 + p.ay;
    EXPECT_TRUE(std::min(p.x0, p.x1) <= x && x <= std::max(p.x0, p.x1) && p.y0 <= y && y <= p.y1);
    EXPECT_NEAR(point(p, 1).x, p.x1, 1e-9);
    EXPECT_NEAR(point(p, 1).y, p.y1, 1e-9);
    const bool straight = p.bx == 0 && p.by == 0;
    if (straight) {
      EXPECT_EQ(p.x0 + 2 * p.ax, p.x1);
    }
  }
}

/// The area that the loops wind around, by Green: exact for quadratic pieces.
double area(const Outlines& o) {
  double sum = 0;
  for (const OutlinePiece& p : o.pieces) {
    // ∫ x dy = Σ over x = x0 + 2 ax t + bx t², dy = (2 ay + 2 by t) dt.
    const double along =
        p.x0 * (p.y1 - p.y0) + 2 * p.ax * (p.ay + 2 * p.by / 3) + 2 * p.bx * (p.ay / 3 + p.by / 4);
    sum -= p.turn * along;
  }
  return std::abs(sum);
}

/// The window's share within the shape, by the distance at the centres of small squares.
double area_by_distance(const Drawn& d, const Shape& shape) {
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
using Shapes = testing::Types<HalfPlane, ParabolaSide, Band, Disc, CutDisc, Ellipse, Triangle, Line,
                              Polyline, QuadStroke, TaperedStroke, Path>;
TYPED_TEST_SUITE(OutlineLaws, Shapes);

TYPED_TEST(OutlineLaws, PiecesAreInOrder) {
  for (const auto& e : examples<TypeParam>()) {
    expect_in_order(Drawn::fill(e.shape, upright(e.size)).outlines);
    expect_in_order(Drawn::rim(e.shape, 0.05 * e.size, upright(e.size)).outlines);
  }
}

TYPED_TEST(OutlineLaws, WindAroundTheInside) {
  for (const auto& e : examples<TypeParam>()) {
    const Drawn d = Drawn::fill(e.shape, upright(e.size));
    for (int i = 0; i < times(4'000); ++i) {
      const glm::dvec2 p = d.place(this->random);
      const double far = d.distance(e.shape, p);
      if (std::abs(far) <= kTolerance + kSnap) continue;
      EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far;
    }
  }
}

/// Unless hidden: inside on both hands.
TYPED_TEST(OutlineLaws, LieOnTheOutlineToTheTolerance) {
  int seen = 0;
  for (const auto& e : examples<TypeParam>()) {
    const Drawn d = Drawn::fill(e.shape, upright(e.size));
    for (const OutlinePiece& piece : d.outlines.pieces)
      for (int i = 1; i < 16; ++i) {
        const glm::dvec2 p = point(piece, i / 16.0);
        if (!kMadeWindow.contains(p)) continue;
        const double far = d.distance(e.shape, p);
        ++seen;
        if (std::abs(far) <= kTolerance + kSnap) continue;
        const glm::dvec2 way{piece.y1 - piece.y0, piece.x0 - piece.x1};
        const glm::dvec2 off = 1e-4 / glm::length(way) * way;
        EXPECT_TRUE(d.inside(p + off) && d.inside(p - off)) << p.x << ' ' << p.y << " d " << far;
      }
  }
  EXPECT_GT(seen, 20);
}

TYPED_TEST(OutlineLaws, EncloseTheArea) {
  for (const auto& e : examples<TypeParam>()) {
    const Drawn d = Drawn::fill(e.shape, upright(e.size));
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

/// The ribbon of all half-widths, thin and wider than the shape.
TYPED_TEST(OutlineLaws, RimsWindAroundTheRibbon) {
  for (const auto& e : examples<TypeParam>()) {
    if constexpr (std::is_same_v<TypeParam, Band>)
      if (is_empty(e.shape)) continue;
    for (const double share : {0.003, 0.05, 0.3, 1.0}) {
      const double width = share * e.size;
      const auto wider = offset_shape(e.shape, width);
      // A stroke that overlaps itself has no outline.
      if (wider && overlaps_itself(Drawn::fill(*wider, upright(4 * e.size)), this->random))
        continue;
      const Drawn d = Drawn::rim(e.shape, width, upright(e.size));
      for (int i = 0; i < times(1'000); ++i) {
        const glm::dvec2 p = d.place(this->random);
        const double far = std::abs(d.distance(e.shape, p)) - 32 * share;
        if (std::abs(far) <= kTolerance + kSnap) continue;
        EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far << " share " << share;
      }
    }
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
      const Drawn d = Drawn::fill(e.shape, map);
      EXPECT_LT(d.outlines.pieces.size(), 4000u);
      const double noise = kTolerance + kSnap + 1e-13 * map.scale() * e.size;
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
    const Drawn d = Drawn::fill(e.shape, map), mirrored = Drawn::fill(e.shape, mirror);
    const Drawn back = Drawn::fill(backwards(e.shape), map);
    for (int i = 0; i < times(1'000); ++i) {
      const glm::dvec2 p = d.place(this->random);
      if (std::abs(d.distance(e.shape, p)) <= kTolerance + kSnap) continue;
      EXPECT_EQ(back.inside(p), d.inside(p)) << p.x << ' ' << p.y;
      EXPECT_EQ(mirrored.inside({64 - p.x, p.y}), d.inside(p)) << p.x << ' ' << p.y;
    }
  }
}

TYPED_TEST(OutlineLaws, OffsetsAreTheDistanceLessTheAmount) {
  for (const auto& e : examples<TypeParam>())
    for (const double amount : {0.3, 0.01, -0.01, -0.15, -2.0}) {
      const auto offset = offset_shape(e.shape, amount);
      if (!offset) continue;
      const Drawn d = Drawn::fill(*offset, upright(e.size));
      for (int i = 0; i < times(500); ++i) {
        const glm::dvec2 p = d.place(this->random);
        const double far = d.distance(e.shape, p) - d.map.scale() * amount;
        if (std::abs(far) <= kTolerance + kSnap) continue;
        EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far << " by " << amount;
      }
    }
}

/// Circles and their arcs enclose their own area, not only to the tolerance.
TEST(OutlineMaker, ArcsAreTrueInArea) {
  for (const double radius : {0.3, 3.0, 29.0}) {
    const Drawn disc = Drawn::fill(Disc{{32, 32}, radius}, {});
    EXPECT_NEAR(area(disc.outlines), 3.141592653589793 * radius * radius,
                0.05 * kTolerance * 6.28 * radius);
    const Drawn line = Drawn::fill(Line{{32, 31}, {32, 32}, radius}, {});
    EXPECT_NEAR(area(line.outlines), (3.141592653589793 * radius + 2) * radius,
                0.05 * kTolerance * 6.28 * radius);
  }
}

/// Numbers by chance or on a lattice, where everything meets everything.
class RandomShapes {
 public:
  explicit RandomShapes(std::uint64_t seed) : r(seed) {}

  Shape next() {
    lattice_ = r.chance(0.3);
    switch (r.below(12)) {
      case 0:
        return HalfPlane{r.direction(), r.between(-30, 80)};
      case 1:
        return side();
      case 2: {
        const ParabolaSide lower = side();
        ParabolaSide upper = side();
        if (r.chance(0.6)) upper.axis = -lower.axis;
        return Band{lower, upper};
      }
      case 3:
        return Disc{point(), width()};
      case 4:
        return CutDisc{point(), width(), r.between(0, 1.2), r.between(0, 1.2), r.direction()};
      case 5:
        return Ellipse{point(), {width(), width()}, r.direction()};
      case 6:
        return Triangle{point(), point(), point()};
      case 7:
        return Line{point(), point(), width()};
      case 8: {
        Polyline s{{}, width()};
        for (int i = 0, n = 1 + r.below(8); i < n; ++i) s.points.push_back(point());
        return s;
      }
      case 9:
        return QuadStroke{curve(), width()};
      case 10:
        return TaperedStroke{curve(), {width(), width(), width()}};
      default:
        return path();
    }
  }

  Random r;

 private:
  glm::dvec2 point() {
    if (lattice_) return 8.0 * glm::dvec2(r.below(9), r.below(9));
    return r.point(-8, 72);
  }
  double width() { return lattice_ ? 4.0 * r.below(4) : r.between(0, 16); }
  ParabolaSide side() { return {point(), r.direction(), r.sign() * r.size(-3, 1)}; }
  /// Every third one turns back on a straight line.
  QuadBezier curve() {
    if (!r.chance(0.3)) return {point(), point(), point()};
    const glm::dvec2 c = point(), way = lattice_ ? glm::dvec2(8, 8) : 20.0 * r.direction();
    const auto on = [&] { return c + (lattice_ ? r.below(5) - 2 : r.between(-1, 1)) * way; };
    return {on(), on(), on()};
  }
  Path path() {
    Path s{{}, r.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
    for (int l = 1 + r.below(2); l > 0; --l) {
      Path::Loop& loop = s.loops.emplace_back();
      const glm::dvec2 first = point();
      glm::dvec2 a = first;
      for (int i = 2 + r.below(4); i > 0; --i) {
        const glm::dvec2 b = i == 1 ? first : point();
        loop.sides.push_back({a, r.chance(0.5) ? 0.5 * (a + b) : point(), b});
        a = b;
      }
    }
    return s;
  }

  bool lattice_ = false;
};

TEST(OutlineMaker, AnyShapeIsFilledWhereItsDistanceIsNegative) {
  RandomShapes shapes(5);
  for (int k = 0; k < times(6'000); ++k) {
    const Shape shape = shapes.next();
    const Drawn d = Drawn::fill(shape, {});
    for (int i = 0; i < 30; ++i) {
      const glm::dvec2 p = d.place(shapes.r);
      const double far = d.distance(shape, p);
      if (!(std::abs(far) > kTolerance + kSnap)) continue;
      EXPECT_EQ(d.inside(p), far < 0)
          << shape_name(shape) << " " << k << ": " << p.x << ' ' << p.y << " d " << far;
    }
  }
}

TEST(OutlineMaker, AnyOutlineHasItsRim) {
  RandomShapes shapes(6);
  for (int k = 0; k < times(3'000); ++k) {
    const Shape shape = shapes.next();
    const double width =
        shapes.r.chance(0.3) ? 4.0 * (1 + shapes.r.below(4)) : shapes.r.size(-2, 1.5);
    if (offset_shape(shape, width)) continue;  // those have no outline if they overlap themselves
    if (const Band* band = std::get_if<Band>(&shape); band && is_empty(*band)) continue;
    const Drawn d = Drawn::rim(shape, width, {});
    for (int i = 0; i < 30; ++i) {
      const glm::dvec2 p = d.place(shapes.r);
      const double far = std::abs(d.distance(shape, p)) - width;
      if (!(std::abs(far) > kTolerance + kSnap)) continue;
      EXPECT_EQ(d.inside(p), far < 0) << shape_name(shape) << " " << k << ": " << p.x << ' ' << p.y
                                      << " d " << far << " width " << width;
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
    const Drawn d = Drawn::fill(shape, {});
    EXPECT_LT(d.outlines.pieces.size(), 5000u) << shape_name(shape);
    const double noise = kTolerance + kSnap + 1e-13 * 100 * scale;
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
      EXPECT_FALSE(Drawn::fill(shape, {}).outlines.pieces.empty());
      EXPECT_TRUE(
          Drawn::fill(transformed(glm::dmat2(1.0), shift, shape), {}).outlines.pieces.empty());
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
      const Drawn fill = Drawn::fill(shape, {}), rim = Drawn::rim(shape, 2.0, {});
      expect_in_order(fill.outlines);
      expect_in_order(rim.outlines);
      for (const OutlinePiece& p : fill.outlines.pieces)
        EXPECT_TRUE(std::isfinite(p.ax + p.ay + p.bx + p.by)) << shape_name(shape);
    }
  expect_in_order(Drawn::rim(Disc{{8, 8}, 4}, nan, {}).outlines);
  expect_in_order(Drawn::rim(Disc{{8, 8}, 4}, inf, {}).outlines);
}

TEST(OutlineMaker, ManyPointsAndSidesTakeTheirTimeOnly) {
  Polyline still{std::vector<glm::dvec2>(1'000'000, {20, 20}), 5};
  EXPECT_LT(Drawn::fill(still, {}).outlines.pieces.size(), 40u);
  still.points.push_back({40, 30});
  EXPECT_LT(Drawn::fill(still, {}).outlines.pieces.size(), 40u);
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
  const Drawn d = Drawn::fill(path, {});
  EXPECT_LE(d.outlines.pieces.size(), 100'001u);
  EXPECT_TRUE(d.inside({32, 32}));
  // Far to the left they are one line along the border.
  const Drawn far = Drawn::fill(path, {{100, 0, 0, 100}, {-4000, -3100}});
  EXPECT_LT(far.outlines.pieces.size(), 20'000u);
}

/// Pieces are what the sweep pays for.
TEST(OutlineMaker, GentleStrokesTakeFewPieces) {
  const QuadBezier arch{{2, 60}, {32, 20}, {62, 60}};
  EXPECT_LT(Drawn::fill(QuadStroke{arch, 3}, {}).outlines.pieces.size(), 40u);
  EXPECT_LT(Drawn::fill(TaperedStroke{arch, {0, 4, 0}}, {}).outlines.pieces.size(), 28u);
  EXPECT_LT(Drawn::fill(Disc{{32, 32}, 20}, {}).outlines.pieces.size(), 21u);
}

/// Spines that all but turn back, or end with all but no speed: rims are arcs there, in no time at all.
TEST(OutlineMaker, StrokesMayBendAsTightlyAsTheyLike) {
  Random r(11);
  for (int i = 0; i < times(2000); ++i) {
    const double tiny = r.size(-12, -1), loose = r.size(-12, -1);
    const auto shaken = [&](glm::dvec2 p, double by) { return p + by * r.point(-1, 1); };
    const glm::dvec2 way = r.direction(), p0 = r.point(-0.6, 0.6), p1 = shaken(p0 + way, tiny);
    const double back = r.chance(0.5) ? 1.0 : r.between(0.2, 0.8);  // ends at p1, or turns back
    const double w = 0.1 + 0.1 * r.unit();
    const TaperedStroke stroke{{p0, p1, shaken(p0 + back * way, tiny)},
                               {w, w + loose * r.between(-1, 1), w + loose * r.between(-1, 1)}};
    const Drawn d = Drawn::fill(stroke, upright(1));
    for (int k = 0; k < 60; ++k) {
      const glm::dvec2 p = d.place(r);
      const double distance = d.distance(stroke, p);
      // Where a rim and a cap run back along each other they are as far apart as either may be off.
      bool right = std::abs(distance) < kTolerance + kSnap || d.inside(p) == (distance < 0);
      for (const glm::dvec2 off : {glm::dvec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        right = right || d.inside(p + 3 * kTolerance * off) == (distance < 0);
      ASSERT_TRUE(right) << i << ", " << tiny << ", " << loose << ": " << distance;
    }
  }
}

TEST(OffsetShape, GrowsWhatItsDistanceGrows) {
  RandomShapes shapes(8);
  int asked = 0;
  for (int k = 0; k < times(4'000); ++k) {
    const Shape shape = shapes.next();
    const double amount = shapes.r.between(-6, 6);
    const auto offset = offset_shape(shape, amount);
    if (!offset) continue;
    for (int i = 0; i < 10; ++i) {
      const glm::dvec2 p = shapes.r.point(-10, 70);
      const double wanted = distance(shape, p) - amount;
      if (std::abs(wanted) < 1e-9) continue;
      EXPECT_EQ(distance(*offset, p) < 0, wanted < 0) << shape_name(shape) << " by " << amount;
      ++asked;
    }
  }
  EXPECT_GT(asked, times(10'000));
  EXPECT_FALSE(offset_shape(Ellipse{{0, 0}, {2, 1}}, 0.5));
  EXPECT_FALSE(offset_shape(Path{}, 0.5));
}

}  // namespace
}  // namespace mien::test
