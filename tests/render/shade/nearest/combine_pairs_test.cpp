#include "render/shade/nearest/combine_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien {
namespace {

/// Distances to straight outlines: each is a branch, and nothing bends.
BranchPair random_pair(test::Random& random) {
  BranchPair pair;
  for (int i = 0; i < BranchPair::kPlaces; ++i) {
    const glm::dvec2 n = random.direction(), m = random.direction();
    const double d = random.between(-2, 2), other = d + random.between(0.1, 2);
    const double length = std::hypot(n.x - m.x, n.y - m.y);
    pair.best.d[i] = float(d), pair.best.nx[i] = float(n.x), pair.best.ny[i] = float(n.y);
    pair.beyond.d[i] = float(other), pair.beyond.nx[i] = float(m.x), pair.beyond.ny[i] = float(m.y);
    pair.off[i] = float((other - d) / length);
    pair.ex[i] = float((n.x - m.x) / length), pair.ey[i] = float((n.y - m.y) / length);
  }
  return pair;
}

double at(const BranchPair::Values& v, int i, double x, double y) {
  return double(v.d[i]) + x * double(v.nx[i]) + y * double(v.ny[i]);
}

/// Both branches meet on the ridge, and the first one holds until there.
void expect_ridges(const BranchPair& pair, Op op) {
  for (int i = 0; i < BranchPair::kPlaces; ++i) {
    if (pair.off[i] > 1e6f) continue;
    const double x = double(pair.off[i]) * double(pair.ex[i]),
                 y = double(pair.off[i]) * double(pair.ey[i]);
    EXPECT_NEAR(at(pair.best, i, x, y), at(pair.beyond, i, x, y),
                2e-4 * (1.0 + double(pair.off[i])))
        << int(op) << " " << i;
    EXPECT_GE(pair.off[i], 0.0f);
  }
}

TEST(CombinePairs, MeetOnTheirRidges) {
  test::Random random(3);
  for (int k = 0; k < 200; ++k) {
    const BranchPair a = random_pair(random), b = random_pair(random);
    for (const Op op :
         {Op::unite, Op::intersect, Op::subtract, Op::offset, Op::shell, Op::complement}) {
      BranchPair made;
      combine_pairs(op, a, b, 0.3f, made);
      expect_ridges(made, op);
      for (int i = 0; i < BranchPair::kPlaces; ++i) {
        const float da = a.best.d[i], db = b.best.d[i];
        const float want = op == Op::unite       ? std::min(da, db)
                           : op == Op::intersect ? std::max(da, db)
                           : op == Op::subtract  ? std::max(da, -db)
                           : op == Op::offset    ? da - 0.3f
                           : op == Op::shell     ? std::abs(da) - 0.3f
                                                 : -da;
        EXPECT_EQ(made.best.d[i], want);
      }
    }
  }
}

TEST(CombinePairs, ANearerRidgeOfTheOtherOperandCounts) {
  BranchPair a{}, b{};
  for (int i = 0; i < BranchPair::kPlaces; ++i) {
    a.off[i] = b.off[i] = BranchPair::kFar;
    a.best.d[i] = -1, a.best.nx[i] = 1, b.best.d[i] = -0.5f, b.best.nx[i] = -1;
  }
  BranchPair made;
  combine_pairs(Op::unite, a, b, 0.0f, made);
  EXPECT_FLOAT_EQ(made.off[0], 0.25f);
  EXPECT_FLOAT_EQ(made.ex[0], 1.0f);
  EXPECT_FLOAT_EQ(made.beyond.d[0], -0.5f);
}

/// A stroke cut by a line along it: of both distances the greater. At x = 0, left of the spine, the line counts; the
/// stroke takes over past its spine, by its other side, and never by the one that is its own here.
TEST(CombinePairs, TheOtherOperandMayTakeOverPastItsOwnRidge) {
  BranchPair line{}, stroke{};
  for (int i = 0; i < BranchPair::kPlaces; ++i) {
    line.off[i] = BranchPair::kFar;
    line.best.d[i] = -0.19f, line.best.nx[i] = -1;  // −0.19 − x
    // |x − 0.01| − 0.234
    stroke.best.d[i] = -0.224f, stroke.best.nx[i] = -1;
    stroke.beyond.d[i] = -0.244f, stroke.beyond.nx[i] = 1;
    stroke.off[i] = 0.01f, stroke.ex[i] = 1;
  }
  for (const bool swapped : {false, true}) {
    BranchPair made;
    combine_pairs(Op::intersect, swapped ? stroke : line, swapped ? line : stroke, 0.0f, made);
    EXPECT_FLOAT_EQ(made.best.d[0], -0.19f);
    EXPECT_NEAR(made.off[0], 0.027f, 1e-6f);
    EXPECT_FLOAT_EQ(made.ex[0], 1.0f);
    EXPECT_FLOAT_EQ(made.beyond.d[0], -0.244f);
    EXPECT_FLOAT_EQ(made.beyond.nx[0], 1.0f);
  }
  // Farther from its spine than from the line's reach the stroke's other side is not its own yet.
  for (int i = 0; i < BranchPair::kPlaces; ++i)
    stroke.best.d[i] = -0.2f, stroke.beyond.d[i] = -0.3f, stroke.off[i] = 0.1f;
  BranchPair made;
  combine_pairs(Op::intersect, line, stroke, 0.0f, made);
  EXPECT_GT(made.off[0], 1e6f);
}

}  // namespace
}  // namespace mien
