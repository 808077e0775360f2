#include "sdf/shape/curve/path.h"

#include "tests/support/shapes/bezier_cases.h"
#include "tests/support/shapes/shape_examples/path.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Path, ShapeLaws, Path);

TEST(Path, IsTheDistanceToTheNearestSide) {
  Random r(4);
  for (const Path& s : kPaths)
    for (int i = 0; i < 500; ++i) {
      const glm::dvec2 p = r.point(-2, 2);
      Real nearest = 1e9;
      for (const Path::Loop& loop : s.loops)
        for (const QuadBezier& side : loop.sides)
          nearest = std::min(nearest, exact_distance(side, p));
      EXPECT_NEAR(std::abs(distance(s, p)), double(nearest), 16 * 0x1p-52);
    }
}

TEST(Path, WindsRightAtTheHeightOfEveryJoint) {
  Random r(5);
  for (const Path& s : kPaths)
    for (const Path::Loop& loop : s.loops)
      for (const QuadBezier& side : loop.sides)
        for (int i = 0; i < 200; ++i) {
          const glm::dvec2 p{r.between(-2, 2), side.p0.y};
          if (std::abs(distance(s, p)) < 1e-12) continue;
          EXPECT_EQ(winding(s, p), winding_upwards(s, p)) << p.x << ' ' << p.y;
        }
}

TEST(Path, SaysWhereItsDistanceIsABound) {
  const bool simple[] = {true, false, false, true, true, true, false, false, false};
  for (std::size_t i = 0; i < kPaths.size(); ++i) {
    EXPECT_EQ(is_simple(kPaths[i]), simple[i]) << i;
    EXPECT_EQ(exactness(Shape(kPaths[i])), (Exactness{true, simple[i]})) << i;
  }
}

TEST(Path, ClosesALoopThatIsOpen) {
  Path open{{kSquare}, FillRule::nonzero};
  open.loops[0].sides.pop_back();
  EXPECT_EQ(distance(open, {0, 0}), -1);
  EXPECT_DOUBLE_EQ(distance(open, {-1.25, 0}), 0.25);
}

TEST(Path, WithoutSidesIsNowhere) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(distance(Path{}, {0, 0}), inf);
  EXPECT_EQ(distance(Path{{Path::Loop{}}, FillRule::nonzero}, {0, 0}), inf);
  EXPECT_TRUE(bounds(Shape(Path{})).empty());
}

}  // namespace mien::test
