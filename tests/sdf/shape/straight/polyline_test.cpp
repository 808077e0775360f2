#include "tests/support/shapes/shape_examples/polyline.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Polyline, ShapeLaws, Polyline);

TEST(Polyline, WithoutPointsIsNowhere) {
  EXPECT_EQ(distance(Polyline{{}, 1}, {0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(bounds(Shape(Polyline{{}, 1})).empty());
}

TEST(Polyline, IsExactInsideOnlyAsOneLine) {
  EXPECT_EQ(exactness(Shape(Polyline{{{0, 0}, {1, 0}}, 1})), (Exactness{true, true}));
  EXPECT_EQ(exactness(Shape(Polyline{{{0, 0}, {1, 0}, {1, 1}}, 1})), (Exactness{true, false}));
}

}  // namespace mien::test
