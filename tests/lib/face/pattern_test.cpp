#include <mien/feature.h>
#include <mien/pattern.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mien {
namespace {

TEST(Pattern, VisitsItsFewNumbers) {
  const auto slices = [](const Figure& figure) {
    std::vector<std::string> all;
    for_each_slice(figure, [&](std::string_view part, int slice) {
      all.push_back(std::string(part) + std::to_string(slice));
    });
    return all;
  };
  using Names = std::vector<std::string>;
  const PatternPatch patch{{1, 2, 3, 4}, 2};
  EXPECT_EQ(slices(ScatterFigure{
                .patch = patch, .mark = {PatternMark::Kind::ellipse, 5, -1, 6}, .chance = {}}),
            (Names{"patch1", "patch2", "patch3", "patch4", "radii5", "tilt6"}));
  EXPECT_EQ(slices(RepeatFigure{
                .points = {1, 2}, .mark = {PatternMark::Kind::stroke, 3, 4, -1}, .chance = {}}),
            (Names{"points1", "points2", "length3", "half_width4"}));
  EXPECT_EQ(slices(StripesFigure{.patch = patch, .half_width = 5, .chance = {}}),
            (Names{"patch1", "patch2", "patch3", "patch4", "half_width5"}));
  EXPECT_EQ(slices(RoundedFigure{1, 2, 3, 4}), (Names{"center1", "radii2", "corner3", "tilt4"}));
  EXPECT_EQ(slices(AreaFigure{}), Names{});
  EXPECT_EQ(slices(AreaFigure{.all = {}, .any = {}, .minus = {}, .grow = 3}), Names{"grow3"});
  EXPECT_EQ(patch.rows(), 2);
}

TEST(Pattern, CountsItsFigures) {
  EXPECT_EQ(figures_in(ScatterFigure{.patch = {}, .columns = 7, .mark = {}, .chance = {}}), 7);
  EXPECT_EQ(
      figures_in(ScatterFigure{.patch = {}, .columns = 7, .rows = 3, .mark = {}, .chance = {}}),
      21);
  EXPECT_EQ(figures_in(RepeatFigure{.points = {}, .count = 4, .mark = {}, .chance = {}}), 4);
  EXPECT_EQ(figures_in(StripesFigure{.patch = {}, .count = 5, .chance = {}}), 5);
  EXPECT_EQ(figures_in(DiscFigure{1, 2}), 1);
}

}  // namespace
}  // namespace mien
