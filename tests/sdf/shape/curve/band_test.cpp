#include "sdf/shape/curve/band.h"
#include <mien/parabola_side.h>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/shape_examples/band.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {
namespace {

/// The pieces of a side's outline that lie in the other side: intervals of u, by scanning and
/// halving.
struct Piece {
  const ParabolaSide* side;
  double lo, hi;
};
void collect(const ParabolaSide& side, const ParabolaSide& other, std::vector<Piece>& pieces) {
  const double reach = 6, step = 1e-3;
  const auto in = [&](double u) { return inside_of(other, point(side, u)) >= 0; };
  bool was = false;
  double begin = 0;
  for (double u = -reach; u <= reach + step; u += step) {
    const bool is = u <= reach && in(u);
    if (is == was) continue;
    double a = u - step, b = u;
    for (int i = 0; i < 60; ++i) (in(0.5 * (a + b)) == was && u <= reach ? a : b) = 0.5 * (a + b);
    if (is)
      begin = u == -reach ? u : b;
    else
      pieces.push_back({&side, begin, u > reach ? reach : a});
    was = is;
  }
}

double to_piece(const Piece& piece, glm::dvec2 p) {
  constexpr int kSteps = 600;
  const auto d = [&](double u) { return norm(point(*piece.side, u) - p); };
  const double h = (piece.hi - piece.lo) / kSteps;
  int best = 0;
  for (int i = 1; i <= kSteps; ++i)
    if (d(piece.lo + i * h) < d(piece.lo + best * h)) best = i;
  double a = std::max(piece.lo, piece.lo + (best - 1) * h),
         b = std::min(piece.hi, piece.lo + (best + 1) * h);
  for (int i = 0; i < 100; ++i) {
    const double x = a + (b - a) / 3, y = b - (b - a) / 3;
    (d(x) < d(y) ? b : a) = d(x) < d(y) ? y : x;
  }
  return d(a);
}

}  // namespace

/// An empty band has no outline to walk to; its distance is a bound.
INSTANTIATE_TYPED_TEST_SUITE_P(Band, ShapeLaws, Band);

TEST(Band, IsTheDistanceToTheSurvivingPieces) {
  Random r(1);
  for (std::size_t k = 0; k < kOpenBands.size(); ++k) {
    const Band& s = kOpenBands[k];
    std::vector<Piece> pieces;
    collect(s.lower, s.upper, pieces);
    collect(s.upper, s.lower, pieces);
    ASSERT_FALSE(pieces.empty());
    for (int i = 0; i < 400; ++i) {
      const glm::dvec2 p = r.point(-2, 2);
      double nearest = 1e9;
      for (const Piece& piece : pieces) nearest = std::min(nearest, to_piece(piece, p));
      EXPECT_NEAR(std::abs(distance(s, p)), nearest, 2e-8) << k << ": " << p.x << ' ' << p.y;
    }
  }
}

TEST(Band, CornersLieOnBothOutlines) {
  const std::size_t expected[] = {2, 2, 2, 2, 4, 0, 0, 2, 2};
  for (std::size_t k = 0; k < kOpenBands.size(); ++k) {
    const BandCorners c = corners(kOpenBands[k]);
    EXPECT_EQ(std::size_t(c.count), expected[k]) << k;
    for (int i = 0; i < c.count; ++i) {
      EXPECT_NEAR(inside_of(kOpenBands[k].lower, c.point[i]), 0, 1e-13) << k;
      EXPECT_NEAR(inside_of(kOpenBands[k].upper, c.point[i]), 0, 1e-13) << k;
    }
  }
}

TEST(Band, IsExactAtItsCorners) {
  const Band lens{above(1, -1), below(1, 1)};  // corners at (±1, 0)
  EXPECT_DOUBLE_EQ(distance(lens, {3, 0}), 2);
  EXPECT_DOUBLE_EQ(distance(lens, {-3, 0}), 2);
  EXPECT_DOUBLE_EQ(distance(lens, {0, 2}), 1);
  EXPECT_EQ(distance(lens, {1, 0}), 0);
  EXPECT_DOUBLE_EQ(distance(Band{above(0.3, 0.2), below(0.1, 0.2)}, {3, 4.2}), 5);  // the one point
}

TEST(Band, WithNothingInItIsOutsideEverywhere) {
  for (const Band& open : kOpenBands) EXPECT_FALSE(is_empty(open));
  EXPECT_FALSE(is_empty(kShutBands[0]));
  EXPECT_TRUE(is_empty(kShutBands[1]));
  EXPECT_TRUE(is_empty(kShutBands[2]));
  EXPECT_EQ(exactness(Shape(kShutBands[1])), (Exactness{false, true}));
  Random r(2);
  const Band nothing{above(0.9, 0.5), below(1, -0.5)};
  for (int i = 0; i < times(2000); ++i) {
    const glm::dvec2 p = r.point(-3, 3);
    EXPECT_GT(distance(nothing, p), 0);
    EXPECT_EQ(distance(nothing, p),
              std::max(distance(nothing.lower, p), distance(nothing.upper, p)));
  }
}

TEST(Band, OfTwoCupsIsBounded) {
  for (const std::size_t k : {0, 1, 2, 3, 4, 8}) {
    const Box2 box = bounds(Shape(kOpenBands[k]));
    EXPECT_LT(box.size().x + box.size().y, 12) << k;
  }
  const Box2 lens = bounds(Shape(Band{above(1, -1), below(1, 1)}));
  EXPECT_NEAR(lens.lo.x, -1, 1e-9);
  EXPECT_NEAR(lens.hi.x, 1, 1e-9);
  EXPECT_NEAR(lens.lo.y, -1, 1e-9);
  EXPECT_NEAR(lens.hi.y, 1, 1e-9);
}

}  // namespace mien::test
