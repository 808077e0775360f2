#pragma once
#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

/// Definition: some point of the spine is within the half-width. Sampled, with the sampling's slack
/// as noise.
inline double inside_of(const QuadStroke& s, glm::dvec2 p) {
  double nearest = 1e9;
  constexpr int kSteps = 4000;
  for (int i = 0; i <= kSteps; ++i)
    nearest = std::min(nearest, norm(point(s.spine, double(i) / kSteps) - p));
  const double legs = norm(s.spine.p1 - s.spine.p0) + norm(s.spine.p2 - s.spine.p1);
  const double slack = legs / kSteps;  // a sample may be this much farther than the nearest point
  const double inside = s.half_width - nearest;
  return inside > 0 || inside < -slack ? inside : 0.0;
}

template <>
inline std::vector<Example<QuadStroke>> examples() {
  std::vector<Example<QuadStroke>> all;
  for (const QuadStroke& s :
       {QuadStroke{{{-1, 0}, {0, 2}, {1, 0}}, 0.3},
        QuadStroke{{{-1, 0}, {0.2, 1.5}, {1, -0.3}}, 0.8},
        QuadStroke{{{0, 0}, {0, 0}, {0, 0}}, 0.5}, QuadStroke{{{-1, -1}, {2, 2}, {0.5, 0.5}}, 0.25},
        QuadStroke{{{-1, 0.5}, {0, 0.5}, {1, 0.5}}, 0.2},
        QuadStroke{{{-0.2, -1}, {0, 1.2}, {0.2, -1}}, 0.02}})
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 2.5, false});
  return all;
}
template <>
inline QuadStroke backwards(QuadStroke s) {
  return {reversed(s.spine), s.half_width};
}

}  // namespace mien::test
