#include "tests/support/shapes/shape_examples/line.h"
#include "tests/support/exact/real128.h"
#include "tests/support/process/effort.h"
#include "tests/support/shapes/shape_laws.h"

namespace mien::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Line, ShapeLaws, Line);

TEST(Line, IsExactAtEverySize) {
  Random r(1);
  WorstError worst;
  for (int i = 0; i < times(40'000); ++i) {
    const double k = i % 2 ? 1 : std::exp2(r.below(1900) - 950);
    const glm::dvec2 a = k * r.point(-1, 1), b = r.chance(0.3)
                                                     ? a + k * r.size(-15, 0) * r.direction()
                                                     : k * r.point(-1, 1);
    const glm::dvec2 p = r.chance(0.3) ? a + r.unit() * (b - a) + k * r.size(-15, 0) * r.direction()
                                       : k * r.size(-3, 3) * r.point(-1, 1);
    const double d = distance(Line{a, b, 0}, p);
    // The reference squares: keep it in range.
    const double in = 1 / k;
    const Real exact = to_segment(in * a, in * b, in * p);
    worst.note(p, d, double(exact - Real(in * d)), in * std::max(norm(p - a), norm(p - b)));
  }
  EXPECT_LE(worst.units, 4.0) << worst;
  EXPECT_EQ(distance(Line{{1e308, 0}, {1e308, 0}, 0}, {-1e308, 0}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(distance(Line{{-1e308, 3}, {1e308, 3}, 1}, {0, 0}), 2);
}

}  // namespace mien::test
