#include "tests/support/shapes/shape_examples/cut_disc.h"
#include "tests/support/exact/real128.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(CutDisc, ShapeLaws, CutDisc);

/// Against the nearest of densely sampled outline points: never farther than one, nearer by no more
/// than a step.
TEST(CutDisc, IsTheDistanceToItsSampledOutline) {
  Random r(3);
  for (const CutDisc& s : kCutDiscs) {
    std::vector<glm::dvec2> outline;
    const glm::dvec2 across{s.up.y, -s.up.x};
    const double hi = std::min(s.upper, 1.0), lo = std::min(s.lower, 1.0), step = 2e-3;
    for (double t = 0; t < 6.2832; t += step)
      if (std::sin(t) <= hi && std::sin(t) >= -lo)
        outline.push_back(s.center + s.radius * (std::cos(t) * across + std::sin(t) * s.up));
    for (const double h : {hi, -lo}) {
      const double w = std::sqrt(1 - h * h);
      for (double x = -w; x <= w; x += step)
        outline.push_back(s.center + s.radius * (x * across + h * s.up));
      outline.push_back(s.center + s.radius * (w * across + h * s.up));
    }
    for (int i = 0; i < 300; ++i) {
      const glm::dvec2 p = r.point(-2.5, 2.5);
      double nearest = 1e9;
      for (const glm::dvec2 q : outline) nearest = std::min(nearest, norm(q - p));
      const double d = std::abs(distance(s, p));
      EXPECT_LE(d, nearest + 1e-12);
      EXPECT_GE(d, nearest - step * s.radius);
    }
  }
}

/// A chord beyond the circle cuts nothing, and makes no box larger.
TEST(CutDisc, IsBoundedByItsCircleWhereNoChordCuts) {
  for (const glm::dvec2 up : {glm::dvec2{0, 1}, glm::dvec2{-1, 0}}) {
    const Box2 box = bounds(CutDisc{{0.2, -0.3}, 1.5, 3, 2, up});
    for (const int i : {0, 1}) {
      EXPECT_NEAR(box.lo[i], (i ? -0.3 : 0.2) - 1.5, 1e-12);
      EXPECT_NEAR(box.hi[i], (i ? -0.3 : 0.2) + 1.5, 1e-12);
    }
  }
}

}  // namespace mien::test
