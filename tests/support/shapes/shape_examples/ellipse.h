#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"

namespace mien::test {

inline double inside_of(const Ellipse& e, glm::dvec2 p) {
  const glm::dvec2 q = p - e.center;
  const double x = (q.x * e.axis.x + q.y * e.axis.y) / e.radii.x,
               y = (e.axis.x * q.y - e.axis.y * q.x) / e.radii.y;
  return 1 - x * x - y * y;
}

template <>
inline std::vector<Example<Ellipse>> examples() {
  std::vector<Example<Ellipse>> all;
  for (const Ellipse& e :
       {Ellipse{{0, 0}, {1, 0.5}, {1, 0}}, Ellipse{{0.3, 0.2}, {0.7, 0.7}, {0, 1}},
        Ellipse{{-0.2, 0.1}, {0.3, 1.2}, {0.6, 0.8}}, Ellipse{{0, 0}, {1, 1e-3}, {1, 0}},
        Ellipse{{0, 0}, {1, 1 - 1e-12}, {1, 0}}})
    all.push_back({e, [e](glm::dvec2 p) { return inside_of(e, p); }, 1.5});
  for (const Ellipse& e : {Ellipse{{0, 0}, {1, 0}, {1, 0}}, Ellipse{{0.1, 0}, {0, 0.5}, {0.6, 0.8}},
                           Ellipse{{0.2, 0.3}, {0, 0}, {1, 0}}})
    all.push_back({e, [](glm::dvec2) { return -1.0; }, 1.5, true});
  return all;
}
template <>
inline Ellipse backwards(Ellipse e) {  // the same ellipse, its other axis first
  return {e.center, {e.radii.y, e.radii.x}, {-e.axis.y, e.axis.x}};
}

}  // namespace mien::test
