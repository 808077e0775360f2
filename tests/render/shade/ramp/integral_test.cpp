#include "render/shade/ramp/integral.h"

#include <gtest/gtest.h>

#include "tests/support/random/random.h"
#include "tests/support/random/random_ramp.h"

namespace mien::test {
namespace {

TEST(RampIntegral, ItsPiecesAreTheRampAndGoOnIntoEachOther) {
  Random r(7);
  for (int i = 0; i < 60; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const auto& pieces = integral.pieces();
    const PieceIndex& index = integral.index();
    ASSERT_EQ(pieces.size() + 1, index.begins.size());
    const double first = ramp.at().front(), length = ramp.at().back() - first;
    const bool repeats = index.period > 0.0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const RampIntegral::Piece& p = pieces[k];
      const bool is_last = k + 1 == pieces.size();
      const double begin = index.begins[k], end = is_last ? index.period : index.begins[k + 1];
      if (is_last && !repeats) break;
      const double u = end - begin;
      if (u > 0.0) {
        const Mix value = integral.mean() + 2.0 * p.c2 + 3.0 * u * p.c3;  // at its middle
        ASSERT_LT(largest(value - ramp.color(first + (begin + 0.5 * u) * length)), 1e-9) << i;
      }
      const RampIntegral::Piece& next = pieces[is_last ? 0 : k + 1];
      ASSERT_LT(largest(p.c0 + u * (p.c1 + u * (p.c2 + u * p.c3)) - next.c0), 1e-12) << i;
      ASSERT_LT(largest(p.c1 + u * (2.0 * p.c2 + 3.0 * u * p.c3) - next.c1), 1e-12) << i;
    }
  }
}

TEST(RampIntegral, OfAStretchIsThatOfARampOfTwoStops) {
  RampIntegral whole, stretch;
  whole.make(
      Ramp({LinearGradient{}, {{0.25, {0, 0, 0, 1}}, {0.75, {1, 0.5, 0, 1}}}}, 1, Blend::linear));
  stretch.make(0.25, 0.75, whole.least(), whole.most());
  ASSERT_EQ(stretch.pieces().size(), whole.pieces().size());
  for (std::size_t k = 0; k < whole.pieces().size(); ++k) {
    const RampIntegral::Piece &a = stretch.pieces()[k], &b = whole.pieces()[k];
    EXPECT_LT(largest(a.c2 - b.c2) + largest(a.c3 - b.c3) + largest(a.c0 - b.c0), 1e-12) << k;
  }
  EXPECT_NEAR(stretch.steepest(), whole.steepest(), 1e-12);
}

}  // namespace
}  // namespace mien::test
