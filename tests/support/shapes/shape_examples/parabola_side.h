#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline double inside_of(const ParabolaSide& s, glm::dvec2 p) {
  const glm::dvec2 q = p - s.vertex;
  const double u = s.axis.x * q.y - s.axis.y * q.x;
  return q.x * s.axis.x + q.y * s.axis.y - s.bend * u * u;
}

template <>
inline std::vector<Example<ParabolaSide>> examples() {
  std::vector<Example<ParabolaSide>> all;
  for (const ParabolaSide s :
       {ParabolaSide{{0, 0}, {0, 1}, 1}, ParabolaSide{{0.3, -0.2}, {0, -1}, 0.9},
        ParabolaSide{{0, 0.5}, {0.6, 0.8}, -0.7}, ParabolaSide{{0, 0}, {1, 0}, 0},
        ParabolaSide{{0, -1}, {0, 1}, 30}, ParabolaSide{{0, 1}, {-1, 0}, 1e-9}})
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 2.0});
  // As thin as rays: p is inside only in theory.
  const ParabolaSide ray{{0, 0}, {0, 1}, 1e40};
  all.push_back({ray, [ray](glm::dvec2 p) { return inside_of(ray, p); }, 2.0, true});
  return all;
}

}  // namespace mien::test
