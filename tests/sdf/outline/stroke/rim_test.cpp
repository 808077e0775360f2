// Ribbons along outlines against the distance.

#include "sdf/shape/curve/band.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "tests/support/process/effort.h"
#include "tests/support/random/random_shapes.h"
#include "tests/support/shapes/drawn_outline.h"
#include "tests/support/shapes/shape_examples/all.h"

namespace mien::test {
namespace {

template <class S>
class RimLaws : public testing::Test {
 protected:
  Random random{11};
};
TYPED_TEST_SUITE(RimLaws, OutlinedShapes);

/// The ribbon of all half-widths, thin and wider than the shape.
TYPED_TEST(RimLaws, WindAroundTheRibbon) {
  for (const auto& e : examples<TypeParam>()) {
    if constexpr (std::is_same_v<TypeParam, Band>)
      if (is_empty(e.shape)) continue;
    for (const double share : {0.003, 0.05, 0.3, 1.0}) {
      const double width = share * e.size;
      const auto wider = offset_shape(e.shape, width);
      // A stroke that overlaps itself has no outline.
      if (wider && overlaps_itself(DrawnOutline::fill(*wider, upright(4 * e.size)), this->random))
        continue;
      const DrawnOutline d = DrawnOutline::rim(e.shape, width, upright(e.size));
      for (int i = 0; i < times(1'000); ++i) {
        const glm::dvec2 p = d.place(this->random);
        const double far = std::abs(d.distance(e.shape, p)) - 32 * share;
        if (std::abs(far) <= kOutlineTolerance + kOutlineSnap) continue;
        EXPECT_EQ(d.inside(p), far < 0) << p.x << ' ' << p.y << " d " << far << " share " << share;
      }
    }
  }
}

TEST(Rim, AnyOutlineHasItsRim) {
  RandomShapes shapes(6);
  for (int k = 0; k < times(3'000); ++k) {
    const Shape shape = shapes.next();
    const double width =
        shapes.r.chance(0.3) ? 4.0 * (1 + shapes.r.below(4)) : shapes.r.size(-2, 1.5);
    if (offset_shape(shape, width)) continue;  // those have no outline if they overlap themselves
    if (const Band* band = std::get_if<Band>(&shape); band && is_empty(*band)) continue;
    const DrawnOutline d = DrawnOutline::rim(shape, width, {});
    for (int i = 0; i < 30; ++i) {
      const glm::dvec2 p = d.place(shapes.r);
      const double far = std::abs(d.distance(shape, p)) - width;
      if (!(std::abs(far) > kOutlineTolerance + kOutlineSnap)) continue;
      EXPECT_EQ(d.inside(p), far < 0) << shape_name(shape) << " " << k << ": " << p.x << ' ' << p.y
                                      << " d " << far << " width " << width;
    }
  }
}

}  // namespace
}  // namespace mien::test
