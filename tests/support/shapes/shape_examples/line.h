#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/exact/real128.h"
#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline Real to_segment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  const Real2 A{a.x, a.y}, B{b.x, b.y}, P{p.x, p.y}, ab = B - A;
  const Real squared = dot(ab, ab);
  Real t = squared > 0 ? dot(P - A, ab) / squared : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return length(P - (A + t * ab));
}

template <>
inline std::vector<Example<Line>> examples() {
  std::vector<Example<Line>> all;
  for (const Line s :
       {Line{{-1, 0}, {1, 0.5}, 0.2}, Line{{0.3, 0.3}, {0.3, 0.3}, 0.5}, Line{{-1, 1}, {1, -1}, 0},
        Line{{0, -1e-9}, {0, 1e-9}, 0.4}, Line{{-2, 0.1}, {2, 0.1}, 1}})
    all.push_back({s, [s](glm::dvec2 p) { return s.half_width - double(to_segment(s.a, s.b, p)); },
                   3.0, s.half_width == 0});
  return all;
}
template <>
inline Line backwards(Line s) {
  return {s.b, s.a, s.half_width};
}

}  // namespace mien::test
