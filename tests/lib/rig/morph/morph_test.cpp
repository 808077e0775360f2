// Item G6: the amount of displacement.

#include <gtest/gtest.h>

#include <mien/face_model.h>
#include <mien/morph.h>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

TEST(Morph, TheLargestShiftIsTheLengthOfTheWeightedDelta) {
  const Face rest = test::face_named("toon"), at_one = test::posed(rest, {"smile=1"});
  for (const char* weight : {"smile=0.5", "smile=-0.7", "smile=1.6"}) {
    const double w = std::stod(std::string(weight).substr(6));
    double wanted = 0;
    for (const Slice& slice : rest.model->layout.slices())
      if (slice.kind == SliceKind::point) {
        const auto i = std::size_t(slice.begin);
        wanted = std::max(wanted, std::hypot(w * (at_one.vector[i] - rest.vector[i]),
                                             w * (at_one.vector[i + 1] - rest.vector[i + 1])));
      }
    const auto shifts = point_shifts(rest, test::posed(rest, {weight}));
    EXPECT_NEAR(largest_shift(shifts), wanted, 1e-12);
    EXPECT_GT(wanted, 0.03);
  }
  EXPECT_EQ(largest_shift(point_shifts(rest, rest)), 0);
  EXPECT_EQ(largest_shift({}), 0);
}

}  // namespace
}  // namespace mien
