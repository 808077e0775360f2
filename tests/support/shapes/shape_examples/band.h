#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"
#include "tests/support/shapes/shape_examples/parabola_side.h"

namespace mien::test {

inline double inside_of(const Band& s, glm::dvec2 p) {
  return std::min(inside_of(s.lower, p), inside_of(s.upper, p));
}

inline ParabolaSide above(double bend, double height) {
  return {{0, height}, {0, 1}, bend};
}
inline ParabolaSide below(double bend, double height) {
  return {{0, height}, {0, -1}, bend};
}

inline const std::vector<Band> kOpenBands = {
    {above(0.9, -0.3), below(1, 0.3)},                         // a lens
    {above(-0.5, 0.1), below(1.5, 0.6)},                       // a crescent
    {above(0, 0), below(1, 0.5)},                              // a segment of a parabola
    {{{0, -0.4}, {0, 1}, 2}, {{0.2, 0.3}, {0.6, -0.8}, 0.7}},  // not parallel
    {{{0, -0.5}, {0, 1}, 3}, {{-0.5, 0}, {1, 0}, 3}},          // crossed: four corners
    {above(1, 0), above(0.25, -0.5)},                          // one inside the other
    {above(0, -0.2), below(0, 0.2)},                           // a strip
    {above(0.9, -0.3), {{0, 0.3}, {0, 1}, -1}},  // upper turned over: two corners, endless
    {above(0.3, -1e-5), below(0.1, 1e-5)},       // nearly shut
};
inline const std::vector<Band> kShutBands = {
    {above(0.3, 0.2), below(0.1, 0.2)},                  // one point
    {above(0.9, 0.5), below(1, -0.5)},                   // nothing
    {{{0, 1}, {0, 1}, 2}, {{0, -1}, {0.6, -0.8}, 0.7}},  // nothing, not parallel
};

template <>
inline std::vector<Example<Band>> examples() {
  std::vector<Example<Band>> all;
  for (const Band& s : kOpenBands)
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 1.5});
  for (const Band& s : kShutBands)
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 1.5, true});
  return all;
}
template <>
inline Band backwards(Band s) {
  return {s.upper, s.lower};
}

}  // namespace mien::test
