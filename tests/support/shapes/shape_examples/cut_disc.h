#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline double inside_of(const CutDisc& s, glm::dvec2 p) {
  const glm::dvec2 q = p - s.center;
  const double v = q.x * s.up.x + q.y * s.up.y, round = s.radius * s.radius - q.x * q.x - q.y * q.y;
  const double top = s.upper < 1 ? s.upper * s.radius - v : 1.0;
  return std::min({round, top, s.lower < 1 ? v + s.lower * s.radius : 1.0});
}

inline const std::vector<CutDisc> kCutDiscs = {
    {{0, 0}, 1, 0.5, 0.7, {0, 1}},    {{0.2, -0.3}, 1.5, 0.1, 2, {0, -1}},
    {{0, 0}, 1, 1, 0.3, {0.6, 0.8}},  {{0.1, 0}, 0.5, 0, 0.4, {1, 0}},
    {{0, 0}, 1.2, 1, 1, {0, 1}},      {{0.1, 0.2}, 1, 0, 0, {0, 1}},
    {{0.3, 0.1}, 0, 0.5, 0.5, {0, 1}}};

template <>
inline std::vector<Example<CutDisc>> examples() {
  std::vector<Example<CutDisc>> all;
  for (const CutDisc& s : kCutDiscs)
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 2.0,
                   s.radius == 0 || s.upper + s.lower == 0});
  return all;
}

}  // namespace mien::test
