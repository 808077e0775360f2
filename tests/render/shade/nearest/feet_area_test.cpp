#include "render/shade/nearest/feet_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

FeetArea area_of(const Shape& shape, AreaDistance& distance) {
  SceneBuilder scene({}, {});
  const Area area = scene.shape(shape);
  distance = AreaDistance(std::move(scene).finish(), area, {});
  return FeetArea(distance, {0, 0});
}

/// Pieces of parabolas for arcs.
TEST(FeetArea, ArcsAreWithinAThousandthOfAPixel) {
  for (const double radius : {0.5, 7.0, 300.0, 5000.0}) {
    AreaDistance distance;
    const FeetArea area = area_of(Ellipse{{3, 4}, {radius, 0.6 * radius}, {0.6, 0.8}}, distance);
    const SpineList& list = area.shapes()[0].list;
    ASSERT_FALSE(list.stroke);
    for (const Spine& s : list.spines)
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
        EXPECT_NEAR(distance.at(on_spine(s, t)), 0.0, 3.1e-4) << radius;
  }
}

/// Every side begins where another ends, and lies on the outline.
TEST(FeetArea, SidesOfClosedShapesGoRound) {
  const ParabolaSide low{{0, -5}, {0, 1}, 0.05}, high{{0, 6}, {0, -1}, 0.1};
  for (const Shape& shape :
       {Shape{Band{low, high}}, Shape{CutDisc{{1, 2}, 9, 0.5, 0.7, {0.6, 0.8}}},
        Shape{Triangle{{0, 0}, {9, 1}, {3, 8}}}}) {
    AreaDistance distance;
    const FeetArea area = area_of(shape, distance);
    const SpineList& list = area.shapes()[0].list;
    ASSERT_GE(list.spines.size(), 2u);
    for (std::size_t i = 0; i < list.spines.size(); ++i) {
      EXPECT_LT(
          glm::distance(on_spine(list.spines[i], 1.0), on_spine(list.spines[list.next[i]], 0.0)),
          1e-6);
      EXPECT_EQ(list.before[list.next[i]], i);
      EXPECT_NEAR(distance.at(on_spine(list.spines[i], 0.5)), 0.0, 3.1e-4);
      const glm::dvec2 way = along_spine(list.spines[i], 0.5), out{way.y, -way.x};
      const glm::dvec2 beside =
          on_spine(list.spines[i], 0.5) + 0.01 * list.spines[i].side * glm::normalize(out);
      EXPECT_GT(distance.at(beside), 0.005);
    }
  }
}

TEST(FeetArea, OfAnEmptyBandHasNoOutline) {
  AreaDistance distance;
  const FeetArea area = area_of(Band{{{0, 5}, {0, 1}, 0.1}, {{0, -5}, {0, -1}, 0.1}}, distance);
  EXPECT_TRUE(area.shapes()[0].slow);
}

}  // namespace
}  // namespace mien
