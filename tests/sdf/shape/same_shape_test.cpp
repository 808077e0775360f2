#include "sdf/shape/same_shape.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

Shape square(double side) {
  const auto line = [](glm::dvec2 p, glm::dvec2 q) { return QuadBezier{p, 0.5 * (p + q), q}; };
  const glm::dvec2 a{0, 0}, b{side, 0}, c{side, side};
  return Path{{{{line(a, b), line(b, c), line(c, a)}}}};
}

TEST(SameShape, IsNumberForNumber) {
  const Shape disc = Disc{{1, 2}, 3}, stroke = Polyline{{{0, 0}, {1, 1}}, 0.1};
  EXPECT_TRUE(same_shape(disc, Disc{{1, 2}, 3}));
  EXPECT_FALSE(same_shape(disc, Disc{{1, 2}, 3.0000001}));
  EXPECT_FALSE(same_shape(disc, stroke));
  EXPECT_TRUE(same_shape(stroke, Polyline{{{0, 0}, {1, 1}}, 0.1}));
  EXPECT_FALSE(same_shape(stroke, Polyline{{{0, 0}, {1, 2}}, 0.1}));
  EXPECT_FALSE(same_shape(stroke, Polyline{{{0, 0}, {1, 1}}, 0.2}));
  EXPECT_TRUE(same_shape(square(1), square(1)));
  EXPECT_FALSE(same_shape(square(1), square(2)));
  Path other = std::get<Path>(square(1));
  other.rule = FillRule::even_odd;
  EXPECT_FALSE(same_shape(square(1), other));
}

TEST(SameShape, HashesAlike) {
  EXPECT_EQ(hash_of(square(1)), hash_of(square(1)));
  EXPECT_NE(hash_of(square(1)), hash_of(square(2)));
  EXPECT_NE(hash_of(Disc{{1, 2}, 3}), hash_of(Disc{{2, 1}, 3}));
}

}  // namespace
}  // namespace mien
