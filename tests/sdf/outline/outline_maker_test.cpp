#include <mien/sdf/outline/outline_maker.h>
#include <mien/sdf/shape/band.h>

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
const Box2 kWindow{{0, 0}, {64, 64}};

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
                    const Box2& window = kWindow) {
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
    maker.begin({map, kWindow, kTolerance}, d.outlines);
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
  glm::dvec2 place(Random& r, const Box2& window = kWindow) const {
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
    const double along = p.x0 * (p.y1 - p.y0) + 2 * p.ax * (p.ay + 2 * p.by / 3) +
                         2 * p.bx * (p.ay / 3 + p.by / 4);
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
        if (!kWindow.contains(p)) continue;
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
    if (box.empty() || !Box2{glm::dvec2(-e.size), glm::dvec2(e.size)}.contains(box.lo) ||
        !Box2{glm::dvec2(-e.size), glm::dvec2(e.size)}.contains(box.hi) ||
        overlaps_itself(d, this->random))
      continue;
    const Shape shape = e.shape;
    if (std::holds_alternative<Path>(shape) && std::get<Path>(shape).loops.size() > 1) continue;
    EXPECT_NEAR(area(d.outlines), area_by_distance(d, shape), 0.12);
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
      if (wider && overlaps_itself(Drawn::fill(*wider, upright(4 * e.size)), this->random)) continue;
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

}  // namespace
}  // namespace mien::test
