#include "lib/geom/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

const Polygon kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST(Polygon, TurnsAroundWhatIsInside) {
  EXPECT_EQ(turns_around(kSquare, {1, 0.5}), 1);
  EXPECT_EQ(turns_around(kSquare, {3, 0.5}), 0);
  EXPECT_EQ(turns_around(kSquare, {-1, 0}), 0) << "level with two corners";
  Polygon back = kSquare;
  std::ranges::reverse(back);
  EXPECT_EQ(turns_around(back, {1, 0.5}), -1);
  Polygon twice = kSquare;
  twice.insert(twice.end(), kSquare.begin(), kSquare.end());
  EXPECT_EQ(turns_around(twice, {1, 0.5}), 2);
  EXPECT_EQ(turns_around({}, {0, 0}), 0);
}

TEST(Polygon, KnowsHowDeepAPointIs) {
  EXPECT_DOUBLE_EQ(depth_inside(kSquare, {0.5, 1}), 0.5);
  EXPECT_DOUBLE_EQ(depth_inside(kSquare, {3, 3}), -std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(way_to_outline({{1, 1}}, {4, 5}), 5);
  EXPECT_TRUE(std::isinf(way_to_outline({}, {0, 0})));
}

TEST(Polygon, MeasuresToASideAsToItsLine) {
  double share = 0;
  EXPECT_DOUBLE_EQ(way_to_side({0, 0}, {4, 0}, {1, 3}, share), 3);
  EXPECT_DOUBLE_EQ(share, 0.25);
  EXPECT_DOUBLE_EQ(way_to_side({0, 0}, {4, 0}, {7, 4}, share), 5);
  EXPECT_DOUBLE_EQ(share, 1);
  EXPECT_DOUBLE_EQ(way_to_side({1, 1}, {1, 1}, {1, 2}, share), 1);
}

TEST(Polygon, HasAnAreaWithASign) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 4);
  EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {0, 2}, {2, 2}, {2, 0}}), -4);
  EXPECT_EQ(signed_area({}), 0);
}

TEST(Polygon, TakesUpCurves) {
  Polygon polygon;
  add_curve({{0, 0}, {1, 2}, {2, 0}}, 4, polygon);
  ASSERT_EQ(polygon.size(), 4u);
  EXPECT_EQ(polygon[0], glm::dvec2(0, 0));
  EXPECT_EQ(polygon[2], glm::dvec2(1, 1));
}

}  // namespace
}  // namespace mien
