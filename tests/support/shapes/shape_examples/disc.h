#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

template <>
inline std::vector<Example<Disc>> examples() {
  std::vector<Example<Disc>> all;
  for (const Disc s :
       {Disc{{0, 0}, 1}, Disc{{0.5, -1}, 0.25}, Disc{{0.3, 0.2}, 0}, Disc{{1e-3, 0}, 1e-2}})
    all.push_back({s,
                   [s](glm::dvec2 p) {
                     const glm::dvec2 q = p - s.center;
                     return s.radius * s.radius - q.x * q.x - q.y * q.y;
                   },
                   3.0, s.radius == 0});
  return all;
}

}  // namespace mien::test
