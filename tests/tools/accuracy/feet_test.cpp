// Foreign solvers of feet, and their table.

#include "tools/accuracy/feet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace mien::accuracy {
namespace {

FeetFamily feet_family(const std::string& name) {
  const auto& all = feet_families();
  return *std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
}

TEST(ForeignFeet, AreJudgedBesideMiensOwn) {
  const FeetSolver foreign = foreign_feet_solver(MIEN_FOREIGN_SOLVER);
  const FeetSolver own = own_feet_solvers().front();
  const auto rows = judge_feet(feet_family("random"), {foreign, own}, 100, 5);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_GT(rows[0].wrong + rows[0].wrong_next, 50u);  // the nearest sample is no foot
  EXPECT_FALSE(rows[0].passes());
  EXPECT_TRUE(rows[1].passes());
  EXPECT_GT(rows[1].with_next, 10u);
  // Others are asked for single curves.
  EXPECT_EQ(judge_feet(feet_family("joints"), {foreign, own}, 3, 5).size(), 1u);
  const auto all = over_feet_families(rows);
  EXPECT_NE(feet_table(all).find("MISSED at {{{"), std::string::npos);
  const std::string csv = feet_csv(rows);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THROW(foreign_feet_solver("libm.so.6"), std::runtime_error);
}

}  // namespace
}  // namespace mien::accuracy
