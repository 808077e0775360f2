#include "render/svg/fragment_loops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

/// A fragment over the height of a piece of its own.
struct Drawn {
  std::vector<Fragment> fragments;
  std::vector<OutlinePiece> pieces;

  void add(OutlinePiece p, bool inside_right, double top, double bottom) {
    fragments.push_back({int(pieces.size()), !inside_right, inside_right, top, bottom});
    pieces.push_back(p);
  }
  void line(glm::dvec2 a, glm::dvec2 b, bool inside_right) {
    const glm::dvec2 half = 0.5 * (b - a);
    add({a.x, a.y, half.x, half.y, 0, 0, b.x, b.y}, inside_right, a.y, b.y);
  }
  void quad(glm::dvec2 a, glm::dvec2 c, glm::dvec2 b, bool inside_right, double top,
            double bottom) {
    const glm::dvec2 first = c - a, bend = b - c - first;
    add({a.x, a.y, first.x, first.y, bend.x, bend.y, b.x, b.y}, inside_right, top, bottom);
  }
  std::vector<FragmentLoop> loops(double tolerance = 1e-3) const {
    return fragment_loops(fragments, pieces, tolerance);
  }
};

double twice_area(const FragmentLoop& loop) {
  double sum = 0;
  glm::dvec2 at = loop.start;
  for (const LoopSide& side : loop.sides) {
    sum += at.x * side.to.y - at.y * side.to.x;
    at = side.to;
  }
  return sum;
}

TEST(FragmentLoops, LevelSidesCloseARectangle) {
  Drawn d;
  d.line({1, 1}, {1, 4}, true);
  d.line({3, 1}, {3, 4}, false);
  const auto loops = d.loops();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].sides.size(), 4u);
  EXPECT_EQ(twice_area(loops[0]), -12) << "the inside is on the left, seen with y down";
}

/// A step: at the middle height one side ends and another begins beside it.
TEST(FragmentLoops, GoOnBesideWhereTheyStep) {
  Drawn d;
  d.line({0, 0}, {0, 2}, true);
  d.line({2, 0}, {2, 1}, false);
  d.line({5, 1}, {5, 2}, false);
  const auto loops = d.loops();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].sides.size(), 6u);
  EXPECT_EQ(twice_area(loops[0]), -2 * (2 + 5));
}

TEST(FragmentLoops, HolesRunTheOtherWay) {
  Drawn d;
  d.line({0, 0}, {0, 9}, true);
  d.line({9, 0}, {9, 9}, false);
  d.line({3, 3}, {3, 6}, false);
  d.line({6, 3}, {6, 6}, true);
  const auto loops = d.loops();
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(twice_area(loops[0]) + twice_area(loops[1]), -2 * (81 - 9));
}

/// Two squares that touch at a corner: whichever way the ends there pair off, loops close.
TEST(FragmentLoops, CloseWhereCornersTouch) {
  Drawn d;
  d.line({0, 0}, {0, 2}, true);
  d.line({2, 0}, {2, 2}, false);
  d.line({2, 2}, {2, 4}, true);
  d.line({4, 2}, {4, 4}, false);
  double area = 0;
  for (const FragmentLoop& loop : d.loops()) {
    EXPECT_EQ(loop.sides.back().to, loop.start);
    area += twice_area(loop);
  }
  EXPECT_EQ(area, -16);
}

TEST(FragmentLoops, PartsOfAParabolaBecomeOne) {
  Drawn d;
  const glm::dvec2 a{1, 0}, c{3, 1}, b{4, 5};
  for (const auto& [top, bottom] : {std::pair{0.0, 1.0}, {1.0, 2.5}, {2.5, 5.0}})
    d.quad(a, c, b, false, top, bottom);
  d.line({0, 0}, {0, 2}, true);
  d.line({0, 2}, {0, 5}, true);
  const auto loops = d.loops(1e-6);
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].sides.size(), 4u);
  int curves = 0;
  for (const LoopSide& side : loops[0].sides)
    if (!side.straight) {
      ++curves;
      EXPECT_NEAR(side.control.x, c.x, 1e-9);
      EXPECT_NEAR(side.control.y, c.y, 1e-9);
    }
  EXPECT_EQ(curves, 1);
}

TEST(FragmentLoops, DifferentParabolasStayTwo) {
  Drawn d;
  d.quad({1, 0}, {3, 1}, {4, 5}, false, 0, 5);
  d.quad({4, 5}, {4.2, 5.9}, {4.25, 8}, false, 5, 8);
  d.line({0, 0}, {0, 8}, true);
  const auto loops = d.loops();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].sides.size(), 5u);
}

TEST(FragmentLoops, OfNothingAreNone) {
  EXPECT_TRUE(fragment_loops({}, {}, 1e-3).empty());
}

}  // namespace
}  // namespace mien
