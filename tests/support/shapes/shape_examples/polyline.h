#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline double inside_of(const Polyline& s, glm::dvec2 p) {
  double best = -1e9;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const glm::dvec2 a = s.points[i == 0 ? 0 : i - 1], b = s.points[i], ab = b - a;
    const double squared = ab.x * ab.x + ab.y * ab.y;
    const double t =
        squared > 0 ? glm::clamp(((p.x - a.x) * ab.x + (p.y - a.y) * ab.y) / squared, 0.0, 1.0) : 0;
    best = std::max(best, s.half_width - std::hypot(p.x - a.x - t * ab.x, p.y - a.y - t * ab.y));
  }
  return best;
}

template <>
inline std::vector<Example<Polyline>> examples() {
  std::vector<Example<Polyline>> all;
  for (const Polyline& s :
       {Polyline{{{-1, 0}, {0, 1}, {1, 0}, {1.5, 1}}, 0.1}, Polyline{{{0.2, 0.3}}, 0.4},
        Polyline{{{0, 0}, {1, 1}}, 0.3}, Polyline{{{-1, 0}, {1, 0}, {-1, 0}, {-1, 0}, {0, 1}}, 0.2},
        Polyline{{{-1, -1}, {1, 1}, {1, -1}}, 0}})
    all.push_back({s, [s](glm::dvec2 p) { return inside_of(s, p); }, 3.0, s.half_width == 0});
  return all;
}
template <>
inline Polyline backwards(Polyline s) {
  return {{s.points.rbegin(), s.points.rend()}, s.half_width};
}

}  // namespace mien::test
