#include "tests/support/effort.h"
#include "tests/support/real128.h"
#include "tests/support/shape_laws.h"

namespace mien::test {
namespace {

Real to_segment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  const Real2 A{a.x, a.y}, B{b.x, b.y}, P{p.x, p.y}, ab = B - A;
  const Real squared = dot(ab, ab);
  Real t = squared > 0 ? dot(P - A, ab) / squared : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return length(P - (A + t * ab));
}

}  // namespace

template <>
std::vector<Example<Line>> examples() {
  std::vector<Example<Line>> all;
  for (const Line s :
       {Line{{-1, 0}, {1, 0.5}, 0.2}, Line{{0.3, 0.3}, {0.3, 0.3}, 0.5}, Line{{-1, 1}, {1, -1}, 0},
        Line{{0, -1e-9}, {0, 1e-9}, 0.4}, Line{{-2, 0.1}, {2, 0.1}, 1}})
    all.push_back({s, [s](glm::dvec2 p) { return s.half_width - double(to_segment(s.a, s.b, p)); },
                   3.0, s.half_width == 0});
  return all;
}
template <>
Line backwards(Line s) {
  return {s.b, s.a, s.half_width};
}
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
