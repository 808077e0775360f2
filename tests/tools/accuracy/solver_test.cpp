// Foreign solvers in the table, and the table as text, numbers and picture.

#include "tools/accuracy/solver.h"

#include <gtest/gtest.h>

#include "tools/accuracy/tally.h"

#include <algorithm>
#include <stdexcept>

namespace mien::accuracy {
namespace {

Family family_of(const std::string& name) {
  const auto& all = families();
  return *std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
}

TEST(ForeignSolver, IsJudgedBesideMiensOwn) {
  const Solver foreign = foreign_solver(MIEN_FOREIGN_SOLVER);
  const Solver own{"own", "", Judge::fast, 0, foreign.figure, scalar_distance};
  const auto on_curve = run(family_of("on curve"), {foreign, own}, 300, 5);
  ASSERT_EQ(on_curve.size(), 2u);
  EXPECT_GT(on_curve[0].bad, 250u);
  EXPECT_GT(on_curve[0].worst, 1e3);
  EXPECT_EQ(on_curve[0].nan, 0u);
  EXPECT_EQ(on_curve[1].bad, 0u);
  EXPECT_LT(on_curve[1].worst, 0.01);
  const auto straight = run(family_of("collinear"), {foreign, own}, 300, 5);
  EXPECT_EQ(straight[0].nan, 300u);
  EXPECT_EQ(straight[1].nan, 0u);
  EXPECT_TRUE(run(family_of("ellipse"), {foreign}, 3, 5).empty());
}

TEST(ForeignSolver, ThatCannotBeLoadedIsASentence) {
  const auto sentence = [](const std::string& path) {
    try {
      foreign_solver(path);
    } catch (const std::runtime_error& problem) {
      return std::string(problem.what());
    }
    return std::string();
  };
  EXPECT_NE(sentence("./nowhere.so").find("nowhere.so"), std::string::npos);
  EXPECT_NE(sentence("libm.so.6").find("has no function mien_accuracy_solve"), std::string::npos);
}

TEST(Table, IsTextNumbersAndAPicture) {
  const auto tallies = run(family_of("random"), {foreign_solver(MIEN_FOREIGN_SOLVER)}, 50, 5);
  EXPECT_NE(table(tallies).find("foreign"), std::string::npos);
  const std::string rows = csv(tallies), picture = svg(tallies);
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2);
  const auto commas = [](const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
  };
  const auto end = rows.find('\n');
  EXPECT_EQ(commas(rows.substr(0, end)), commas(rows.substr(end + 1)));
  EXPECT_EQ(picture.find("<svg"), 0u);
  EXPECT_NE(picture.find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace mien::accuracy
