#include "sdf/arrange/sweep.h"

#include <gtest/gtest.h>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/arranged.h"
#include "tests/support/shapes/sweep_probe.h"

namespace mien::test {
namespace {

constexpr double kSide = 32;
const Box2 kWindow{{-1, -1}, {kSide + 1, kSide + 1}};

/// Discs, ellipses, strokes and paths over themselves; with `lattice` all of them on points that they
/// share.
std::vector<Shape> random_shapes(Random& r, bool lattice) {
  const auto at = [&] {
    if (!lattice) return r.point(-4, kSide + 4);
    const double x = 4.0 * r.below(9);
    return glm::dvec2{x, 4.0 * r.below(9)};
  };
  const auto size = [&] { return lattice ? 2.0 * (1 + r.below(3)) : r.between(0.3, 9.0); };
  std::vector<Shape> shapes;
  for (int i = 0; i < 7; ++i) {
    const glm::dvec2 a = at(), b = at(), c = at(), d = at();
    switch (r.below(5)) {
      case 0:
        shapes.push_back(Disc{a, size()});
        break;
      case 1: {
        const double wide = size();
        shapes.push_back(Ellipse{a, {wide, size()}});
        break;
      }
      case 2:
        shapes.push_back(Line{a, b, 0.25 * size()});
        break;
      case 3:
        shapes.push_back(QuadStroke{{a, b, c}, 0.1 * size()});
        break;
      default: {
        Path path{.rule = r.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
        path.loops.push_back({{{a, r.chance(0.5) ? 0.5 * (a + b) : c, b},
                               {b, d, c},
                               {c, 0.5 * (c + d), d},
                               {d, 0.5 * (d + a), a}}});
        shapes.push_back(path);
      }
    }
  }
  return shapes;
}

Arranged arranged(std::span<const Shape> shapes) {
  return {outlines_of(shapes, kWindow), 0.0, kSide};
}

template <class Rule>
bool doubted(const ArrangedBy<Rule>& a, glm::dvec2 p, double margin) {
  for (const Doubt& d : a.sweep.doubts())
    if (p.x >= d.left - margin && p.x <= d.right + margin && p.y >= d.top - margin &&
        p.y <= d.bottom + margin)
      return true;
  return false;
}

/// How far from a place the nearest piece passes along its row.
double nearest_crossing(const Outlines& outlines, glm::dvec2 p) {
  double least = HUGE_VAL;
  for (const OutlinePiece& piece : outlines.pieces)
    if (piece.y0 <= p.y && p.y <= piece.y1)
      least = std::min(least, std::abs(mien::x_at(piece, p.y) - p.x));
  return least;
}

class EverySweep : public testing::TestWithParam<bool> {
 protected:
  template <class Look>
  void over_random_arrangements(int count, Look&& look) {
    for (int seed = 0; seed < times(count); ++seed) {
      Random r(std::uint64_t(seed) + 100);
      Arranged a = arranged(random_shapes(r, GetParam()));
      SCOPED_TRACE(seed);
      look(a, r);
      if (HasFailure()) return;
    }
  }
};

TEST_P(EverySweep, LooksTelescopeAlongEveryRow) {
  over_random_arrangements(200, [](Arranged& a, Random& r) {
    for (int i = 0; i < 60; ++i) {
      const double y = r.between(0, kSide);
      ASSERT_GE(a.shown({1e6, y}), 0) << y;
      const auto row = a.row(y);
      bool tied = false;  // x does not tell the order of pieces at one place
      for (std::size_t k = 1; k < row.size(); ++k) tied |= row[k].x - row[k - 1].x < 1e-3;
      for (std::size_t k = 1; k < row.size() && !tied; ++k)
        ASSERT_EQ(row[k].left, row[k - 1].right) << y;
    }
  });
}

TEST_P(EverySweep, EveryPlaceHasTheLookOfItsOutlines) {
  over_random_arrangements(200, [](Arranged& a, Random& r) {
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 p = r.point(0, kSide);
      if (nearest_crossing(a.outlines, p) < 2 * kOrder || doubted(a, p, 0.0)) continue;
      ASSERT_EQ(a.shown(p), a.look_at(p)) << p.x << ", " << p.y;
    }
  });
}

TEST_P(EverySweep, EveryPlaceHasTheLookOfItsTopmostLayer) {
  over_random_arrangements(400, [](Arranged& all, Random& r) {
    ArrangedLayers a(all.outlines, 0.0, kSide);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 p = r.point(0, kSide);
      if (nearest_crossing(a.outlines, p) < 2 * kOrder || doubted(a, p, 0.0)) continue;
      ASSERT_EQ(a.shown(p), a.look_at(p)) << p.x << ", " << p.y;
    }
  });
}

/// Green: the sum of the fragments' own areas to the right, per look, is the look's area.
TEST_P(EverySweep, AreasByGreenAreThoseOfSampledRows) {
  over_random_arrangements(60, [](Arranged& a, Random&) {
    constexpr int kRows = 6400;
    std::map<int, double> green, rows;
    for (const Fragment& f : a.sweep.fragments()) {
      const OutlinePiece& p = a.sweep.piece(f.piece);
      constexpr int kParts = 64;
      double area = 0.0;  // between the piece and x = kSide + 100
      const double h = (f.bottom - f.top) / kParts;
      for (int i = 0; i < kParts; ++i)
        area += h * (kSide + 100 - mien::x_at(p, f.top + (i + 0.5) * h));
      green[f.right] += area, green[f.left] -= area;
    }
    for (int i = 0; i < kRows; ++i) {
      const double y = (i + 0.5) * kSide / kRows;
      for (const Arranged::Crossed& c : a.row(y)) {
        rows[c.right] += (kSide + 100 - c.x) * kSide / kRows;
        rows[c.left] -= (kSide + 100 - c.x) * kSide / kRows;
      }
    }
    double sum = 0.0;
    for (const auto& [look, area] : green) {
      ASSERT_NEAR(area, rows[look], 2.0) << look;
      sum += area;
    }
    ASSERT_NEAR(sum, 0.0, 1e-6);
  });
}

QuadBezier side(glm::dvec2 p, glm::dvec2 q) {
  return {p, 0.5 * (p + q), q};
}

Shape polygon(std::vector<glm::dvec2> at) {
  Path path{{Path::Loop{}}};
  for (std::size_t i = 0; i < at.size(); ++i)
    path.loops[0].sides.push_back(side(at[i], at[(i + 1) % at.size()]));
  return path;
}

void expect_topmost(ArrangedLayers& a) {
  EXPECT_TRUE(a.sweep.doubts().empty());
  for (double y = 1.01; y < kSide; y += 0.25)
    for (double x = 0.13; x < kSide; x += 0.25)
      if (nearest_crossing(a.outlines, {x, y}) > 2 * kOrder) {
        ASSERT_EQ(a.shown({x, y}), a.look_at({x, y})) << x << ", " << y;
      }
}

/// A layer beneath a cover, its left side hidden, and on the cover two whose sides cross there and back. One of these
/// crosses the hidden side too: once, farther down in the same step, or there and back.
TEST(Sweep, SidesThatCrossAHiddenOneAreProvenBesideItsOtherNeighbour) {
  for (const double bottom : {18.0, 14.0})
    for (const bool mirrored : {false, true}) {
      const double top = bottom == 14 ? 14 : 11, hidden = bottom == 14 ? 12 : 16;
      const auto at = [&](double x, double y) { return glm::dvec2{mirrored ? 32 - x : x, y}; };
      const std::vector<Shape> shapes{
          polygon({at(hidden, 1), at(30, 1), at(30, 15), at(hidden, 15)}),
          polygon({at(1, 1), at(31, 1), at(31, 15), at(1, 15)}),
          polygon({at(2, 1), at(10, 1), at(10, 15), at(2, 15)}),
          polygon({at(top, 1), at(28, 1), at(28, 15), at(bottom, 15), at(9, 7)}),
      };
      ArrangedLayers a(outlines_of(shapes, kWindow), 0, kSide);
      expect_topmost(a);
    }
}

/// Two hidden sides, and two that cross each other there and back between them.
TEST(Sweep, SidesThatCrossHiddenOnesFromBothSidesAreProvenApart) {
  const std::vector<Shape> shapes{
      polygon({{10, 1}, {20, 1}, {20, 15}, {10, 15}}),
      polygon({{1, 1}, {31, 1}, {31, 15}, {1, 15}}),
      polygon({{2, 1}, {8, 1}, {16, 8}, {8, 15}, {2, 15}}),
      polygon({{22, 1}, {30, 1}, {30, 15}, {22, 15}, {14, 8}}),
  };
  ArrangedLayers a(outlines_of(shapes, kWindow), 0, kSide);
  expect_topmost(a);
}

/// A fan so slender that of any two neighbours it does not show which is left: of the first and the last it does.
TEST(Sweep, ManySlightCrossingsAreCrossings) {
  constexpr int kBlades = 60;
  std::vector<Shape> shapes;
  for (int i = 0; i < kBlades; ++i) {
    const double top = 10 + 0.9 * kOrder * i, bottom = 10 + 0.9 * kOrder * (kBlades - i);
    shapes.push_back(polygon({{top, 1}, {30, 1}, {30, 15}, {bottom, 15}}));
  }
  ArrangedLayers a(outlines_of(shapes, kWindow), 0, kSide);
  const auto row = a.row(14.5);  // the last one covers all others
  ASSERT_FALSE(row.empty());
  EXPECT_EQ(row[0].left, 0);
  EXPECT_EQ(row[0].right, kBlades);
  EXPECT_LT(row[0].x, 10 + 3 * kOrder);
}

TEST(Sweep, OrdersNothingAlongTheSides) {
  std::vector<Shape> shapes;
  for (const double middle : {0.0, 2 * kSide})  // cut at the left side, and at the right one
    for (int i = 0; i < 12; ++i) {
      const double l = middle - 4 - i, r = middle + 4 + i;
      shapes.push_back(polygon({{l, -9}, {r, -9}, {r, 99}, {l, 99}}));
    }
  Arranged a = arranged(shapes);
  EXPECT_EQ(a.sweep.stats().crossings + a.sweep.stats().forced, 0);
  for (const double x : {0.5, 4.5, 9.5, 15.5, 20.5})
    EXPECT_EQ(a.shown({x, 12.0}), a.look_at({x, 12.0})) << x;
}

TEST_P(EverySweep, NothingIsLeftInDoubt) {
  long doubts = 0, forced = 0, pieces = 0;
  over_random_arrangements(400, [&](Arranged& a, Random&) {
    doubts += long(a.sweep.doubts().size()), forced += a.sweep.stats().forced;
    pieces += a.sweep.stats().pieces;
  });
  EXPECT_LE(doubts, times(400) / 50);
  EXPECT_LE(forced, pieces / 4);
}

INSTANTIATE_TEST_SUITE_P(Anywhere, EverySweep, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(OnALattice, EverySweep, testing::Values(true));

TEST(Sweep, NothingGivesNothing) {
  const Arranged a({}, 0, kSide);
  EXPECT_TRUE(a.sweep.fragments().empty());
  EXPECT_TRUE(a.sweep.doubts().empty());
}

TEST(Sweep, ADiscIsItsOutline) {
  const Shape shapes[] = {Disc{{16, 16}, 8}};
  const Arranged a = arranged(shapes);
  EXPECT_EQ(a.sweep.fragments().size(), a.outlines.pieces.size());
  EXPECT_EQ(a.regions.count(), 2);
}

TEST(Sweep, WhatCrossesNothingIsInOrderFromItsBeginning) {
  const Shape shapes[] = {Disc{{8, 16}, 7}, Disc{{24, 16}, 7},
                          polygon({{16, 3}, {16, 30}, {15.5, 16}}),
                          polygon({{2, 1}, {20, 1}, {20, 2}, {2, 2}}), Disc{{24, 16}, 3}};
  const Arranged a = arranged(shapes);
  EXPECT_EQ(a.sweep.stats().crossings + a.sweep.stats().forced, 0);
}

TEST(Sweep, CopiesLeaveThroughASideAndComeBack) {
  const auto zigzag = [](double x, double out) {
    return polygon({{x, 1}, {out, 6}, {x, 11}, {out, 16}, {x, 21}, {out, 26}, {x, 31}, {16, 16}});
  };
  const Shape shapes[] = {zigzag(4, -9),  zigzag(4, -9),  zigzag(4, -9),
                          zigzag(28, 41), zigzag(28, 41), zigzag(28, 41)};
  Arranged a = arranged(shapes);
  for (double y = 0.3; y < kSide; y += 0.5)
    for (double x = 0.25; x < kSide; x += 0.5)
      if (nearest_crossing(a.outlines, {x, y}) > 2 * kOrder) {
        ASSERT_EQ(a.shown({x, y}), a.look_at({x, y})) << x << ", " << y;
      }
}

TEST(Sweep, OutlinesThatCoincideCancelTheirWidth) {
  const Shape disc = Disc{{16, 16}, 8}, shapes[] = {disc, disc, disc};
  Arranged a = arranged(shapes);
  for (double y = 8.5; y < 24; y += 0.37) {
    const auto row = a.row(y);
    ASSERT_EQ(row.size(), 6u);
    EXPECT_EQ(row[0].x, row[2].x);
    EXPECT_EQ(row[3].x, row[5].x);
  }
  EXPECT_TRUE(a.sweep.doubts().empty());
}

TEST(Sweep, FragmentsLieBetweenTheHeightsAsked) {
  Random r(9);
  const std::vector<Shape> shapes = random_shapes(r, false);
  const Arranged a(outlines_of(shapes, kWindow), 10.25, 19.5);
  EXPECT_FALSE(a.sweep.fragments().empty());
  for (const Fragment& f : a.sweep.fragments()) {
    EXPECT_GE(f.top, 10.25);
    EXPECT_LE(f.bottom, 19.5);
    EXPECT_LT(f.top, f.bottom);
    EXPECT_NE(f.left, f.right);
  }
}

TEST(Sweep, APartOfThePictureHasTheLooksOfTheWhole) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random r(seed);
    const std::vector<Shape> shapes = random_shapes(r, seed % 2 == 0);
    Arranged part(outlines_of(shapes, kWindow), 11, 23);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 p{r.between(0, kSide), r.between(11, 23)};
      if (nearest_crossing(part.outlines, p) < 2 * kOrder || doubted(part, p, 0.0)) continue;
      ASSERT_EQ(part.shown(p), part.look_at(p)) << seed;
    }
  }
}

/// A square from x = 2 to 10, and one from x = 12 to 20 whose left side is made to jump over the right
/// side of the first, unknown to its neighbours: from (5, 6) it runs back to (12, 12).
Outlines with_a_jump() {
  const auto square = [](double left, double right, double middle) {
    return polygon({{left, 2}, {right, 2}, {right, 30}, {left, 30}, {left, middle}});
  };
  const Shape shapes[] = {square(2, 10, 16), square(12, 20, 6)};
  Outlines o = outlines_of(shapes, kWindow);
  for (OutlinePiece& p : o.pieces)
    if (chain_of(o, p).outline == 1 && p.x0 == 12 && p.y0 == 6) p.x0 = 5, p.ax = 3.5;
  return o;
}

TEST(Sweep, AWrongOrderIsPutRightAtOnce) {
  Arranged a(with_a_jump(), 0, kSide);
  EXPECT_GT(a.sweep.stats().forced + a.sweep.stats().crossings, 0);
  for (double y = 3.01; y < kSide; y += 0.5)
    for (double x = 0.25; x < kSide; x += 0.5)
      ASSERT_EQ(a.shown({x, y}), a.look_at({x, y})) << x << ", " << y;
}

/// A step of a stair jumps over a side that it crosses back farther down: moved at once, not found by shorter steps.
TEST(Sweep, LevelPiecesMoveTheirChainAtTheTopOfAStep) {
  const std::vector<Shape> shapes{polygon({{2, 1}, {8, 1}, {8, 5}, {14, 5}, {6, 15}, {2, 15}}),
                                  polygon({{10, 5}, {28, 5}, {28, 15}, {10, 15}})};
  ArrangedLayers a(outlines_of(shapes, kWindow), 0, kSide);
  expect_topmost(a);
  EXPECT_EQ(a.sweep.stats().halvings, 0);
  EXPECT_GT(a.sweep.stats().forced, 0);
}

/// A side with a bulge in most rows, over a straight one.
std::vector<Shape> bulges_over_a_line() {
  const auto box = [](double left, double right) {
    return polygon({{left, 2}, {right, 2}, {right, 30}, {left, 30}});
  };
  Path bulging = std::get<Path>(box(3, 15.8));
  std::vector<QuadBezier>& sides = bulging.loops[0].sides;
  std::vector<QuadBezier> right;
  glm::dvec2 at = sides[1].p0;
  for (double y = 4; y < 28; ++y) {
    const glm::dvec2 from{15.8, y + 0.1}, to{15.8, y + 0.9};
    right.push_back(side(at, from));
    right.push_back({from, {16.8, y + 0.5}, to});
    at = to;
  }
  right.push_back(side(at, sides[1].p2));
  sides.erase(sides.begin() + 1);
  sides.insert(sides.begin() + 1, right.begin(), right.end());
  return {bulging, box(16, 28)};
}

TEST(Sweep, WhatIsNotProvenIsDoubted) {
  const std::vector<Shape> shapes = bulges_over_a_line();
  Arranged a = arranged(shapes);
  EXPECT_TRUE(a.sweep.doubts().empty());
  EXPECT_EQ(a.sweep.stats().crossings, 48);
  SweepProbe::never_halve(a.sweep);
  a.sweep.run(a.outlines, 0, kSide, a.regions);
  const auto doubts = a.sweep.doubts();
  ASSERT_EQ(doubts.size(), 2u);  // in each band
  EXPECT_EQ(doubts[0].top, 2);
  EXPECT_EQ(doubts[0].bottom, 16);
  EXPECT_EQ(doubts[1].bottom, 30);
  for (const Doubt& d : doubts) {
    EXPECT_NEAR(d.left, 15.8, 1e-6);
    EXPECT_NEAR(d.right, 16.3, 1e-6);
  }
}

/// Every band alone, the lowest first, has the fragments that it has in the whole.
TEST_P(EverySweep, BeginsAtAnyBandWithTheSameFragments) {
  over_random_arrangements(200, [](Arranged& a, Random&) {
    constexpr int kBands = 2;
    static_assert(kBands * Sweep::kBandRows == int(kSide));
    a.sweep.run_in_bands(a.outlines, 0, int(kSide), a.regions, kOrder);
    for (int band = kBands - 1; band >= 0; --band) {
      Sweep alone;
      alone.run_in_bands(a.outlines, band * Sweep::kBandRows, (band + 1) * Sweep::kBandRows,
                         a.regions, kOrder);
      const auto own = alone.of_band(0), all = a.sweep.of_band(band);
      ASSERT_EQ(own.size(), all.size()) << band;
      for (std::size_t i = 0; i < own.size(); ++i) {
        ASSERT_EQ(own[i].piece, all[i].piece);
        ASSERT_EQ(own[i].left, all[i].left);
        ASSERT_EQ(own[i].right, all[i].right);
        ASSERT_EQ(own[i].top, all[i].top);
        ASSERT_EQ(own[i].bottom, all[i].bottom);
      }
    }
  });
}

TEST(Sweep, BandsThatBeginAtVerticesBeginAsFromAbove) {
  // Steps of a stair whose corners lie on the border of bands, level and vertical sides on it, copies, and fans.
  const std::vector<Shape> shapes{
      polygon({{2, 8}, {10, 8}, {10, 16}, {20, 16}, {20, 28}, {2, 28}}),
      polygon({{4, 16}, {28, 16}, {28, 24}, {4, 24}}),
      polygon({{4, 4}, {28, 4}, {28, 16}, {4, 16}}),
      polygon({{4, 4}, {28, 4}, {28, 16}, {4, 16}}),
      polygon({{16, 16}, {10, 2}, {12, 2}}),
      polygon({{16, 16}, {20, 2}, {22, 2}}),
      polygon({{16, 16}, {10, 30}, {12, 30}}),
      polygon({{16, 16}, {20, 30}, {22, 30}}),
  };
  Arranged a = arranged(shapes);
  a.sweep.run_in_bands(a.outlines, 0, int(kSide), a.regions, kOrder);
  Sweep below;
  below.run_in_bands(a.outlines, 16, int(kSide), a.regions, kOrder);
  const auto own = below.of_band(0), all = a.sweep.of_band(1);
  ASSERT_EQ(own.size(), all.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].piece, all[i].piece);
    EXPECT_EQ(own[i].left, all[i].left);
    EXPECT_EQ(own[i].right, all[i].right);
  }
  for (double y = 16.25; y < kSide; y += 0.5)
    for (double x = 0.3; x < kSide; x += 0.5)
      if (nearest_crossing(a.outlines, {x, y}) > 2 * kOrder) {
        ASSERT_EQ(a.shown({x, y}), a.look_at({x, y})) << x << ", " << y;
      }
}

TEST(Sweep, SweepingAnewForgetsAll) {
  Random r(3);
  const std::vector<Shape> first = random_shapes(r, false), second = random_shapes(r, true);
  Arranged fresh = arranged(second), used = arranged(first);
  const Outlines outlines = outlines_of(second, kWindow);
  SetRule rule(int(outlines.rules.size()));
  used.regions.begin(int(outlines.rules.size()), rule);
  used.sweep.run(outlines, 0, kSide, used.regions);
  ASSERT_EQ(used.sweep.fragments().size(), fresh.sweep.fragments().size());
  for (std::size_t i = 0; i < fresh.sweep.fragments().size(); ++i) {
    EXPECT_EQ(used.sweep.fragments()[i].piece, fresh.sweep.fragments()[i].piece);
    EXPECT_EQ(used.sweep.fragments()[i].top, fresh.sweep.fragments()[i].top);
  }
}

}  // namespace
}  // namespace mien::test
