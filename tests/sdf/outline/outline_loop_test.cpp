#include "sdf/outline/outline_loop.h"

#include <gtest/gtest.h>

#include "tests/support/shapes/outline_sight.h"

namespace mien::test {
namespace {

struct Written {
  Outlines outlines;
  OutlineLoop loop;

  explicit Written(const Box2& window = {{0, 0}, {64, 64}}) {
    loop.frame(window, 1.0 / 800, outlines);
    loop.outline(FillRule::nonzero);
  }
};

TEST(OutlineLoop, CutsWhereXOrYTurns) {
  Written w;
  w.loop.begin({10, 10});
  w.loop.quad({30, 50}, {50, 10});  // y turns once, x never
  w.loop.close();
  w.loop.finish();
  EXPECT_EQ(w.outlines.pieces.size(), 3u);
  ASSERT_EQ(w.outlines.chains.size(), 2u);  // the level side and half the curve, and its other half
  EXPECT_EQ(w.outlines.pieces[std::size_t(w.outlines.chains[0].last)].y1, 30);
  EXPECT_EQ(w.outlines.ends.size(), 2u);
  EXPECT_EQ(std::abs(winding(w.outlines, 0, {30, 20})), 1);
  EXPECT_EQ(winding(w.outlines, 0, {30, 31}), 0);
}

TEST(OutlineLoop, KeepsWindingsWhereItCuts) {
  for (const double size : {30.0, 100.0, 1e4, 1e9}) {
    Written w;
    w.loop.begin({32 - size, 32});
    w.loop.quad({32, 32 - size}, {32 + size, 32});
    w.loop.line({32 + size, 50});
    w.loop.line({32 - size, 50});
    w.loop.close();
    w.loop.finish();
    EXPECT_LT(w.outlines.pieces.size(), 12u);
    EXPECT_EQ(std::abs(winding(w.outlines, 0, {32, 49})), 1);
    EXPECT_EQ(winding(w.outlines, 0, {32, 51}), 0);
    for (const OutlinePiece& p : w.outlines.pieces)
      for (const glm::dvec2 v : {glm::dvec2{p.x0, p.y0}, {p.x1, p.y1}})
        EXPECT_TRUE(v.x >= -2 && v.x <= 66 && v.y >= -2 && v.y <= 66);
  }
}

TEST(OutlineLoop, DropsWhatEnclosesNothingHere) {
  Written w;
  w.loop.begin({-50, 10});  // left of the window
  w.loop.line({-10, 20});
  w.loop.line({-50, 30});
  w.loop.close();
  w.loop.begin({10, 10});  // a point
  w.loop.line({10, 10});
  w.loop.close();
  w.loop.begin({10, 10});  // no number
  w.loop.line({std::nan(""), 10});
  w.loop.line({20, 20});
  w.loop.close();
  w.loop.finish();
  EXPECT_TRUE(w.outlines.pieces.empty());
  EXPECT_TRUE(w.outlines.chains.empty());
  EXPECT_TRUE(w.outlines.ends.empty());
}

TEST(OutlineLoop, OfWaysThereAndBackKeepsOneLine) {
  const glm::dvec2 from{5, 7}, way{0.3, 0.9};
  for (const double bend : {0.0, 4.0}) {
    Written w;
    w.loop.begin(from);
    for (int i = 1; i < 100; ++i) {
      const glm::dvec2 to = from + double(i * 37 % 50) * way;
      w.loop.quad(0.5 * (w.loop.at() + to) + bend * glm::dvec2{way.y, -way.x}, to);
    }
    w.loop.close();
    w.loop.finish();
    if (bend == 0.0)
      EXPECT_LE(w.outlines.pieces.size(), 4u);
    else
      EXPECT_GE(w.outlines.pieces.size(), 100u);
  }
}

TEST(OutlineLoop, CountsBackwards) {
  Written w;
  for (const bool backwards : {false, true}) {
    const double r = backwards ? 5 : 10;
    w.loop.set_backwards(backwards);
    w.loop.begin({32 - r, 32 - r});
    w.loop.line({32 + r, 32 - r});
    w.loop.line({32 + r, 32 + r});
    w.loop.line({32 - r, 32 + r});
    w.loop.close();
  }
  w.loop.finish();
  EXPECT_NE(winding(w.outlines, 0, {25, 32}), 0);
  EXPECT_EQ(winding(w.outlines, 0, {32, 32}), 0);
}

TEST(OutlineLoop, GoesAlongABorderInOnePiece) {
  Written w;
  w.loop.begin({32, 32});
  for (int i = 0; i < 1000; ++i)
    w.loop.line({-100.0 - i % 7, 10.0 + 40 * ((i * 37) % 100) / 100.0});
  w.loop.close();
  w.loop.finish();
  EXPECT_LT(w.outlines.pieces.size(), 8u);
}

}  // namespace
}  // namespace mien::test
