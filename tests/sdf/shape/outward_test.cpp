#include "sdf/shape/outward.h"
#include "sdf/shape/shape_distances.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

/// A wheel of straight sides, and the same by the even-odd rule with every second one crossing its neighbour.
Path wheel(int sides, int step) {
  Path path{{Path::Loop{}}, FillRule::even_odd};
  const auto at = [&](int i) {
    const double turn = 2 * 3.141592653589793 * double(i * step) / sides;
    return glm::dvec2{20 * std::cos(turn), 20 * std::sin(turn)};
  };
  for (int i = 0; i < sides; ++i)
    path.loops[0].sides.push_back({at(i), 0.5 * (at(i) + at(i + 1)), at(i + 1)});
  return path;
}

/// Away from ridges, where differences to both sides agree.
void expect_gradient(const Shape& shape) {
  const ShapeDistances asked(1);
  Random r(8);
  int judged = 0;
  for (int i = 0; i < 600; ++i) {
    const glm::dvec2 p = r.point(-25, 25);
    const Outward found = asked.outward(0, shape, p);
    EXPECT_NEAR(found.d, distance(shape, p), 1e-10);
    constexpr double kStep = 1e-4;
    const auto slope = [&](glm::dvec2 by) {
      const double before = distance(shape, p - by), after = distance(shape, p + by);
      return std::abs(after - 2.0 * found.d + before) < 1e-7 ? (after - before) / (2 * kStep)
                                                             : HUGE_VAL;
    };
    const glm::dvec2 want{slope({kStep, 0}), slope({0, kStep})};
    if (!std::isfinite(want.x + want.y)) continue;
    ++judged;
    EXPECT_NEAR(glm::distance(found.normal, want), 0.0, 1e-4) << p.x << ' ' << p.y;
  }
  EXPECT_GT(judged, 300);
}

TEST(Outward, IsTheDistanceAndItsGradient) {
  expect_gradient(Disc{{1, 2}, 9});
  expect_gradient(wheel(12, 1));  // asked side by side
  expect_gradient(wheel(48, 1));  // by its tree, once it was asked often
  expect_gradient(wheel(47, 5));  // which crosses itself
}

TEST(Outward, OfNothingIsFarAway) {
  const ShapeDistances asked(1);
  EXPECT_EQ(asked.outward(0, Path{}, {1, 2}).d, HUGE_VAL);
}

}  // namespace
}  // namespace mien::test
