#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline double left_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

inline double inside_of(const Triangle& s, glm::dvec2 p) {
  const double way = left_of(s.a, s.b, s.c) < 0 ? -1 : 1;
  return std::min(
      {way * left_of(s.a, s.b, p), way * left_of(s.b, s.c, p), way * left_of(s.c, s.a, p)});
}

template <>
inline std::vector<Example<Triangle>> examples() {
  std::vector<Example<Triangle>> all;
  for (const Triangle s :
       {Triangle{{-1, -1}, {1.5, -0.5}, {0, 1}}, Triangle{{0, 1}, {1, -1}, {-1, -1}},
        Triangle{{-1, 0}, {1, 0.01}, {0.2, 0.3}}})
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }});
  for (const Triangle s :
       {Triangle{{-1, 0}, {1, 0}, {0.5, 0}}, Triangle{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}},
        Triangle{{-1, -1}, {1, 1}, {1, 1}}})
    all.push_back({s, [](glm::dvec2) { return -1.0; }, 3.0, true});
  return all;
}
template <>
inline Triangle backwards(Triangle s) {
  return {s.c, s.b, s.a};
}

}  // namespace mien::test
