#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

template <>
inline std::vector<Example<HalfPlane>> examples() {
  std::vector<Example<HalfPlane>> all;
  for (const HalfPlane s :
       {HalfPlane{{0, 1}, 0.5}, HalfPlane{{-1, 0}, 0.25}, HalfPlane{{0.6, 0.8}, 0.0}})
    all.push_back(
        {s, [s](glm::dvec2 p) { return s.offset - s.normal.x * p.x - s.normal.y * p.y; }});
  return all;
}

}  // namespace mien::test
