#include "render/svg/path_data.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

LoopSide line_to(double x, double y) {
  return {{0, 0}, {x, y}, true};
}

TEST(PathData, DecimalsKeepWithinTheError) {
  EXPECT_EQ(decimals_for(1.0), 0);
  EXPECT_EQ(decimals_for(0.71), 0);
  EXPECT_EQ(decimals_for(0.70), 1);
  EXPECT_EQ(decimals_for(1e-3), 3);
  EXPECT_EQ(decimals_for(1e-30), 9);
}

TEST(PathData, NumbersAreShort) {
  EXPECT_EQ(short_decimal(0, 3), "0");
  EXPECT_EQ(short_decimal(-0.0001, 3), "0");
  EXPECT_EQ(short_decimal(0.5, 3), ".5");
  EXPECT_EQ(short_decimal(-0.05, 3), "-.05");
  EXPECT_EQ(short_decimal(12.3456, 3), "12.346");
  EXPECT_EQ(short_decimal(100, 3), "100");
  EXPECT_EQ(short_decimal(100, 0), "100");
  EXPECT_EQ(short_decimal(-7.6, 0), "-8");
}

TEST(PathData, LettersAreSaidOnceAndTheLastLineIsZ) {
  const FragmentLoop loop{
      {1, 2}, {line_to(3, 2), line_to(3, 4.25), {{2, 5}, {1, 4.25}, false}, line_to(1, 2)}};
  EXPECT_EQ(path_data({&loop, 1}, 2), "M1 2l2 0 0 2.25q-1 .75-2 0z");
}

/// Each point is rounded in its place: errors do not add up along the path.
TEST(PathData, RelativeStepsDoNotDrift) {
  FragmentLoop loop{{0, 0}, {}};
  for (int i = 1; i <= 300; ++i) loop.sides.push_back(line_to(i / 3.0, i % 2));
  loop.sides.push_back(line_to(0, 0));
  const std::string text = path_data({&loop, 1}, 1);
  double x = 0, y = 0;
  int count = 0;
  for (std::size_t at = text.find('l') + 1; text[at] != 'z';) {
    std::size_t used = 0;
    (count % 2 ? y : x) += std::stod(text.substr(at), &used);
    at += used, ++count;
  }
  EXPECT_EQ(count, 600);
  EXPECT_NEAR(x, 100, 1e-9);
  EXPECT_NEAR(y, 0, 1e-9);
}

/// The least that encloses something: three lines, a line and a curve, two curves.
TEST(PathData, TheLeastLoopsAreThere) {
  const FragmentLoop triangle{{0, 0}, {line_to(2, 0), line_to(2, 2), line_to(0, 0)}},
      segment{{0, 0}, {{{1, 2}, {2, 0}, false}, line_to(0, 0)}},
      lens{{0, 0}, {{{1, 2}, {2, 0}, false}, {{1, -2}, {0, 0}, false}}};
  EXPECT_EQ(path_data({&triangle, 1}, 0), "M0 0l2 0 0 2z");
  EXPECT_EQ(path_data({&segment, 1}, 0), "M0 0q1 2 2 0z");
  EXPECT_EQ(path_data({&lens, 1}, 0), "M0 0q1 2 2 0-1-2-2 0z");
  const FragmentLoop all[] = {triangle, {{1, 1}, {line_to(9, 1), line_to(1, 1)}}, segment};
  EXPECT_EQ(path_data(all, 0), "M0 0l2 0 0 2zM0 0q1 2 2 0z");
}

TEST(PathData, WhatRoundsToNothingIsLeftOut) {
  const FragmentLoop loops[] = {{{1, 1}, {line_to(1.01, 1), line_to(1.01, 1.01), line_to(1, 1)}},
                                {{1, 1}, {line_to(9, 1), line_to(1, 1)}},
                                {{1, 1}, {{{1.02, 1}, {1.03, 1}, false}, line_to(1, 1)}}};
  EXPECT_EQ(path_data(loops, 1), "");
  EXPECT_EQ(path_data({}, 1), "");
}

}  // namespace
}  // namespace mien
