#include <gtest/gtest.h>
#include <mien/box2.h>

namespace mien {
namespace {

TEST(Box2, BeginsEmptyAndHoldsNothing) {
  const Box2 none;
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.contains({0, 0}));
  EXPECT_TRUE(around(none, Box2{}).empty());
}

TEST(Box2, GrowsAroundPointsAndBoxes) {
  const Box2 two = around(around(Box2{}, glm::dvec2{3, -1}), glm::dvec2{1, 5});
  EXPECT_EQ(two.lo, glm::dvec2(1, -1));
  EXPECT_EQ(two.hi, glm::dvec2(3, 5));
  EXPECT_EQ(two.size(), glm::dvec2(2, 6));
  EXPECT_EQ(two.center(), glm::dvec2(2, 2));
  const Box2 more = around(two, Box2{{0, 0}, {2, 9}});
  EXPECT_EQ(more.lo, glm::dvec2(0, -1));
  EXPECT_EQ(more.hi, glm::dvec2(3, 9));
  EXPECT_EQ(around(two, Box2{}).hi, two.hi) << "an empty box adds nothing";
  EXPECT_EQ(grown(two, 0.5).lo, glm::dvec2(0.5, -1.5));
  EXPECT_TRUE(grown(two, -1.5).empty()) << "shrunk to less than nothing";
}

TEST(Box2, ContainsItsSides) {
  const Box2 box{{0, 0}, {2, 1}};
  for (const glm::dvec2 p : {glm::dvec2{0, 0}, {2, 1}, {2, 0}, {1, 0.5}})
    EXPECT_TRUE(box.contains(p));
  for (const glm::dvec2 p : {glm::dvec2{-1e-9, 0}, {2, 1.001}, {3, 0.5}, {1, -1}})
    EXPECT_FALSE(box.contains(p));
  EXPECT_FALSE(box.contains({std::numeric_limits<double>::quiet_NaN(), 0}));
}

}  // namespace
}  // namespace mien
