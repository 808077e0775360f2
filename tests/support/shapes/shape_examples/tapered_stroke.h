#pragma once
#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

/// Definition: p is in some disc. Sampled; within the sampling's slack the answer is 0, "on the
/// outline".
inline double inside_of(const TaperedStroke& s, glm::dvec2 p) {
  double depth = -1e9;
  constexpr int kSteps = 4000;
  const QuadBezier w{{s.half_width[0], 0}, {s.half_width[1], 0}, {s.half_width[2], 0}};
  for (int i = 0; i <= kSteps; ++i) {
    const double t = double(i) / kSteps;
    depth = std::max(depth, point(w, t).x - norm(point(s.spine, t) - p));
  }
  const double legs = norm(s.spine.p1 - s.spine.p0) + norm(s.spine.p2 - s.spine.p1) +
                      std::abs(s.half_width[1] - s.half_width[0]) +
                      std::abs(s.half_width[2] - s.half_width[1]);
  return depth > 0 || depth < -2 * legs / kSteps ? depth : 0.0;
}

template <>
inline std::vector<Example<TaperedStroke>> examples() {
  std::vector<Example<TaperedStroke>> all;
  for (const TaperedStroke& s : {TaperedStroke{{{-1, 0}, {0, 1.5}, {1, 0}}, {0.05, 0.4, 0.1}},
                                 TaperedStroke{{{-1, 0}, {0.3, 1}, {1, -0.4}}, {0.3, 0, 0.3}},
                                 TaperedStroke{{{-1, 0}, {0, 1}, {1, 0}}, {0.2, 0.2, 0.2}},
                                 TaperedStroke{{{0, 0}, {0, 0}, {0, 0}}, {0.1, 0.5, 0.3}},
                                 TaperedStroke{{{-1, 0}, {0, 0}, {1, 0}}, {0, 0.5, 0}},
                                 TaperedStroke{{{-0.1, 0}, {0, 0.1}, {0.1, 0}}, {0.1, 0.3, 1}},
                                 TaperedStroke{{{-1, -1}, {2, 2}, {0.5, 0.5}}, {0.1, 0.2, 0.4}}})
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 2.5});
  const TaperedStroke bare{{{-1, 0}, {0, 1.5}, {1, 0}}, {0, 0, 0}};
  all.push_back({bare, [bare](glm::dvec2 p) { return inside_of(bare, p); }, 2.5, true});
  return all;
}
template <>
inline TaperedStroke backwards(TaperedStroke s) {
  return {reversed(s.spine), {s.half_width[2], s.half_width[1], s.half_width[0]}};
}

}  // namespace mien::test
