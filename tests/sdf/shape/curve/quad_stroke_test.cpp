#include "tests/support/shapes/shape_examples/quad_stroke.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(QuadStroke, ShapeLaws, QuadStroke);

TEST(QuadStroke, IsExactInsideUpToTheCentresOfCurvature) {
  const QuadBezier arch{{-1, 0}, {0, 2}, {1, 0}};  // sharpest at the top: radius 1/2
  EXPECT_EQ(exactness(Shape(QuadStroke{arch, 0.5})), (Exactness{true, true}));
  EXPECT_EQ(exactness(Shape(QuadStroke{arch, 0.51})), (Exactness{true, false}));
  EXPECT_EQ(exactness(Shape(QuadStroke{{{0, 0}, {1, 0}, {2, 0}}, 9})), (Exactness{true, true}));
}

}  // namespace mien::test
