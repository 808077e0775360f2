// What a legend shows of a column, and where it says that the middle is.

#include "tools/mien/data/chernoff_faces.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

/// A legend's captions and numbers for a column of these cells.
std::vector<std::pair<std::string, double>> legend(ChernoffScale scale,
                                                   const std::vector<std::string>& cells) {
  Table table{.name = "t.csv", .columns = {"size"}, .rows = {}};
  for (const std::string& cell : cells) table.rows.push_back({cell});
  ChernoffMap map;
  map.features.push_back(
      {.column = "size", .name = "eye.size", .scale = scale, .from = {}, .to = {0, 1}});
  std::vector<std::pair<std::string, double>> shown;
  const auto faces = chernoff_legend(table, map, map.features[0]);
  for (const ChernoffFace& face : *faces)
    shown.emplace_back(face.label, face.recipe.numbers.at("eye.size"));
  return shown;
}

using Shown = std::vector<std::pair<std::string, double>>;

TEST(Legend, OfALinearColumnHasTheMiddleOfItsEnds) {
  const Shown wanted{{"size: 1", 0}, {"size: 50.5", 0.5}, {"size: 100", 1}};
  const Shown shown = legend(ChernoffScale::linear, {"1", "100", "2"});
  ASSERT_EQ(shown.size(), wanted.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].first, wanted[i].first);
    EXPECT_DOUBLE_EQ(shown[i].second, wanted[i].second);
  }
}

TEST(Legend, OfAColumnByRankHasItsMedian) {
  EXPECT_EQ(legend(ChernoffScale::rank, {"1", "100", "2"}),
            (Shown{{"size: 1", 0}, {"size: 2", 0.5}, {"size: 100", 1}}));
  // Of two in the middle their mean, which is half-way between them.
  EXPECT_EQ(legend(ChernoffScale::rank, {"1", "100", "2", "4"}),
            (Shown{{"size: 1", 0}, {"size: 3", 0.5}, {"size: 100", 1}}));
  EXPECT_EQ(legend(ChernoffScale::rank, {"7", "7"}),
            (Shown{{"size: 7", 0.5}, {"size: 7", 0.5}, {"size: 7", 0.5}}));
}

TEST(Legend, OfAColumnByQuartileHasItsMedianWhereItsRowWouldBe) {
  const Shown shown = legend(ChernoffScale::quartile, {"1", "2", "3", "4", "500"});
  EXPECT_EQ(shown[1].first, "size: 3");
  EXPECT_DOUBLE_EQ(shown[1].second, 2 / 3.0);
}

TEST(Legend, OfAColumnWithEqualEndsShowsTheEndsPlaces) {
  // Equals share the mean of their ranks, in the legend as in the faces.
  EXPECT_EQ(legend(ChernoffScale::rank, {"1", "1", "2"}),
            (Shown{{"size: 1", 0.25}, {"size: 1", 0.25}, {"size: 2", 1}}));
}

}  // namespace
}  // namespace mien::command
