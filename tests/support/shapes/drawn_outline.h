#pragma once
// An outline drawn alone, to be compared with its shape's distance.

#include "sdf/outline/outline_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "tests/support/random/random.h"
#include "tests/support/shapes/outline_sight.h"

namespace mien::test {

inline constexpr double kOutlineTolerance = 1.0 / 800;
/// Rounding of vertices, and of the distance.
inline constexpr double kOutlineSnap = 4e-6;
inline const Box2 kOutlineWindow{{0, 0}, {64, 64}};

/// (−size, size)² on the window, y up.
inline Map<GridSpace, FaceSpace> upright(double size) {
  const double k = 32 / size;
  return {{k, 0, 0, -k}, {32, 32}};
}

/// One outline in its window.
struct DrawnOutline {
  Outlines outlines;
  Map<GridSpace, FaceSpace> map;
  Map<FaceSpace, GridSpace> back;

  explicit DrawnOutline(const Map<GridSpace, FaceSpace>& m) : map(m), back(inverse(m)) {}

  static DrawnOutline fill(const Shape& shape, const Map<GridSpace, FaceSpace>& map,
                           const Box2& window = kOutlineWindow) {
    DrawnOutline d(map);
    OutlineMaker maker;
    maker.begin({map, window, kOutlineTolerance}, d.outlines);
    EXPECT_EQ(maker.fill(shape), 0);
    maker.finish();
    return d;
  }
  static DrawnOutline rim(const Shape& shape, double width, const Map<GridSpace, FaceSpace>& map) {
    DrawnOutline d(map);
    OutlineMaker maker;
    maker.begin({map, kOutlineWindow, kOutlineTolerance}, d.outlines);
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
  glm::dvec2 place(Random& r, const Box2& window = kOutlineWindow) const {
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
inline bool overlaps_itself(const DrawnOutline& d, Random& r) {
  for (int i = 0; i < 400; ++i)
    if (std::abs(winding(d.outlines, 0, d.place(r))) > 1) return true;
  return false;
}

inline void expect_in_order(const Outlines& o) {
  const auto on_grid = [](double v) { return std::ldexp(v, 20) == std::round(std::ldexp(v, 20)); };
  for (const OutlinePiece& p : o.pieces) {
    EXPECT_TRUE(on_grid(p.x0) && on_grid(p.y0) && on_grid(p.x1) && on_grid(p.y1));
    EXPECT_TRUE(p.y0 < p.y1 || (p.y0 == p.y1 && p.x0 < p.x1));
    const double x = p.x0 + p.ax, y = p.y0 + p.ay;
    EXPECT_TRUE(std::min(p.x0, p.x1) <= x && x <= std::max(p.x0, p.x1) && p.y0 <= y && y <= p.y1);
    EXPECT_NEAR(point(p, 1).x, p.x1, 1e-9);
    EXPECT_NEAR(point(p, 1).y, p.y1, 1e-9);
    const bool straight = p.bx == 0 && p.by == 0;
    if (straight) {
      EXPECT_EQ(p.x0 + 2 * p.ax, p.x1);
    }
  }
  int pieces = 0;
  for (const OutlineChain& c : o.chains) {
    ASSERT_EQ(c.first, pieces);
    ASSERT_LE(c.first, c.last);
    pieces = c.last + 1;
    EXPECT_TRUE(c.turn == 1 || c.turn == -1);
    for (int i = c.first; i < c.last; ++i) {
      const OutlinePiece &p = o.pieces[std::size_t(i)], &q = o.pieces[std::size_t(i) + 1];
      EXPECT_TRUE(p.x1 == q.x0 && p.y1 == q.y0);
    }
  }
  EXPECT_EQ(std::size_t(pieces), o.pieces.size());
  std::vector<int> begun(o.chains.size(), 0), ended(o.chains.size(), 0);
  for (std::size_t i = 0; i < o.ends.size(); ++i) {
    const OutlineEnd& e = o.ends[i];
    EXPECT_TRUE(i == 0 || o.ends[i - 1].y < e.y ||
                (o.ends[i - 1].y == e.y && o.ends[i - 1].x <= e.x));
    EXPECT_TRUE(e.other >= 0 || e.x == o.left || e.x == o.right);
    for (const int chain : {e.chain, e.other}) {
      if (chain < 0) continue;
      const OutlineChain& c = o.chains[std::size_t(chain)];
      const OutlinePiece &first = o.pieces[std::size_t(c.first)],
                         &last = o.pieces[std::size_t(c.last)];
      EXPECT_TRUE(e.begins ? e.x == first.x0 && e.y == first.y0 : e.x == last.x1 && e.y == last.y1);
      ++(e.begins ? begun : ended)[std::size_t(chain)];
    }
    if (e.other < 0) continue;
    const OutlineChain &c = o.chains[std::size_t(e.chain)], &d = o.chains[std::size_t(e.other)];
    EXPECT_EQ(c.outline, d.outline);
    EXPECT_EQ(c.turn, -d.turn);
  }
  for (std::size_t i = 0; i < o.chains.size(); ++i) EXPECT_TRUE(begun[i] == 1 && ended[i] == 1);
}

/// Every shape that has an outline.
using OutlinedShapes = testing::Types<HalfPlane, ParabolaSide, Band, Disc, CutDisc, Ellipse,
                                      Triangle, Line, Polyline, QuadStroke, TaperedStroke, Path>;

}  // namespace mien::test
