#include <mien/feature.h>

#include <gtest/gtest.h>

#include <vector>

namespace mien {
namespace {

std::vector<int> slices(const Figure& figure) {
  std::vector<int> all;
  for_each_slice(figure, [&](std::string_view, int slice) { all.push_back(slice); });
  return all;
}

/// Inspectors and readers rest on this list: a slice that it forgets would be nobody's.
TEST(Figure, VisitsEverySlice) {
  EXPECT_EQ(slices(BandFigure{1, 2, 3}), (std::vector{1, 2, 3}));
  EXPECT_EQ(slices(EllipseFigure{1, 2, -1}), (std::vector{1, 2}));
  EXPECT_EQ(slices(EllipseFigure{1, 2, 3}), (std::vector{1, 2, 3}));
  EXPECT_EQ(slices(DiscFigure{1, 2}), (std::vector{1, 2}));
  EXPECT_EQ(slices(CutDiscFigure{1, 2, 3}), (std::vector{1, 2, 3}));
  EXPECT_EQ(slices(StrokeFigure{{1, 2, 3}, 4}), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(slices(PolylineFigure{{1, 2}, 3}), (std::vector{1, 2, 3}));
  EXPECT_EQ(
      slices(PathFigure{
          {{{{1, false}, {2, true}, {3, false}}}, {{{4, true}, {5, true}, {6, true}}}}, false}),
      (std::vector{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(slices(OpeningFigure{1, 2, 3, 4}), (std::vector{1, 2, 3, 4}));
}

}  // namespace
}  // namespace mien
