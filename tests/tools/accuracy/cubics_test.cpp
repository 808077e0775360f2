#include "tools/accuracy/cubics.h"

#include <gtest/gtest.h>
#include "sdf/distance/instruction_sets.h"

namespace mien::accuracy {
namespace {

class CubicsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(CubicsOf, AreSolvedWithoutARootMissedOrInvented) {
  for (const CubicSolver& solver : own_cubic_solvers()) {
    const CubicTally tally = judge_cubics(cubic_families()[GetParam()], 3'000, 20, solver);
    EXPECT_TRUE(tally.passes()) << cubic_table({tally});
  }
  batch::use_instruction_set(0);
}
INSTANTIATE_TEST_SUITE_P(Every, CubicsOf, testing::Range<std::size_t>(0, cubic_families().size()));

TEST(Cubics, APlantedErrorOfOneInAMillionAndALostRootAreCaught) {
  const auto off = [](double a, double b, double c, double d) {
    Roots r = solve_cubic(a, b, c, d);
    for (double& x : r.x) x *= 1 + 1e-6;
    return r;
  };
  const auto lost = [](double a, double b, double c, double d) {
    Roots r = solve_cubic(a, b, c, d);
    if (r.count == 3) r.count = 2;
    return r;
  };
  const auto extra = [](double a, double b, double c, double d) {
    Roots r = solve_cubic(a, b, c, d);
    if (r.count == 1) r = {2, {r.x[0], r.x[0] + 0.5}};
    return r;
  };
  const CubicFamily& three = cubic_families()[0];
  EXPECT_GT(judge_cubics(three, 100, 1, one_by_one("off", off)).missed, 0u);
  EXPECT_EQ(judge_cubics(three, 100, 1, one_by_one("lost", lost)).missed, 100u);
  EXPECT_GT(judge_cubics(cubic_families()[1], 100, 1, one_by_one("extra", extra)).invented, 80u);
}

/// An error of one part in a million in the batches' roots is seen on every instruction set.
TEST(Cubics, APlantedErrorInABatchIsCaught) {
  for (const CubicSolver& solver : own_cubic_solvers()) {
    CubicSolver off = solver;
    off.solve = [&](std::span<const Cubic> cubics, std::span<Roots> out) {
      solver.solve(cubics, out);
      for (Roots& r : out) r.x[0] *= 1 + 1e-6;
    };
    EXPECT_GT(judge_cubics(cubic_families()[0], 100, 1, off).missed, 50u) << solver.name;
  }
  batch::use_instruction_set(0);
}

TEST(Cubics, AreTheSameForTheSameSeed) {
  Random a(5), b(5);
  for (const CubicFamily& f : cubic_families()) EXPECT_EQ(f.draw(a), f.draw(b));
}

}  // namespace
}  // namespace mien::accuracy
