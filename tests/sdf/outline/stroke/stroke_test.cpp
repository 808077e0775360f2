// Outlines of strokes: few pieces, and spines that bend tightly.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/drawn_outline.h"
#include "tests/support/effort.h"
#include "tests/support/random.h"

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

}  // namespace
}  // namespace mien::test
