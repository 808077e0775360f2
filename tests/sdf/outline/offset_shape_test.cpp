// Shapes that are as much wider or narrower.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/process/effort.h"
#include "tests/support/random/random_shapes.h"
#include "tests/support/shapes/drawn_outline.h"
#include "tests/support/shapes/shape_examples/all.h"

namespace mien::test {
namespace {

template <class S>
class OffsetLaws : public testing::Test {
 protected:
  Random random{11};
};
TYPED_TEST_SUITE(OffsetLaws, OutlinedShapes);

TYPED_TEST(OffsetLaws, AreTheDistanceLessTheAmount) {
  for (const auto& e : examples<TypeParam>())
    for (const double amount : {0.3, 0.01, -0.01, -0.15, -2.0}) {
      const auto offset = offset_shape(e.shape, amount);
      if (!offset) continue;
      const DrawnOutline d = DrawnOutline::fill(*offset, upright(e.size));
      for (int i = 0; i < times(500); ++i) {
        const glm::dvec2 p = d.place(this->random);
        const double far = d.distance(e.shape, p) - d.map.scale() * amount;
        if (std::abs(far) <= kOutlineTolerance + kOutlineSnap) continue;
        EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far << " by " << amount;
      }
    }
}

TEST(OffsetShape, GrowsWhatItsDistanceGrows) {
  RandomShapes shapes(8);
  int asked = 0;
  for (int k = 0; k < times(4'000); ++k) {
    const Shape shape = shapes.next();
    const double amount = shapes.r.between(-6, 6);
    const auto offset = offset_shape(shape, amount);
    if (!offset) continue;
    for (int i = 0; i < 10; ++i) {
      const glm::dvec2 p = shapes.r.point(-10, 70);
      const double wanted = distance(shape, p) - amount;
      if (std::abs(wanted) < 1e-9) continue;
      EXPECT_EQ(distance(*offset, p) < 0, wanted < 0) << shape_name(shape) << " by " << amount;
      ++asked;
    }
  }
  EXPECT_GT(asked, times(10'000));
  EXPECT_FALSE(offset_shape(Ellipse{{0, 0}, {2, 1}}, 0.5));
  EXPECT_FALSE(offset_shape(Path{}, 0.5));
}

}  // namespace
}  // namespace mien::test
