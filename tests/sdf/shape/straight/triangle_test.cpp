#include "tests/support/shapes/shape_examples/triangle.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Triangle, ShapeLaws, Triangle);

TEST(Triangle, KnownDistances) {
  const Triangle s{{0, 0}, {4, 0}, {0, 3}};
  EXPECT_DOUBLE_EQ(distance(s, {1, 1}), -1);
  EXPECT_EQ(distance(s, {2, -2}), 2);
  EXPECT_EQ(distance(s, {-3, -4}), 5);
  EXPECT_DOUBLE_EQ(distance(s, {4, 3}), 2.4);
}

}  // namespace mien::test
