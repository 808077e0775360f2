#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace mien {

/// Signed distance to an area, and the unit vector in which it grows.
struct Outward {
  double d = 0;
  glm::dvec2 normal{0.0};
};

/// The unit vector in which `at`, which is d at p, grows. [of coordinates' unit] Distances are good to 1e-12 of it, and
/// bend by less than 1 over themselves: the step leaves less than 1e-5.
template <class At>
glm::dvec2 way_of_growth(glm::dvec2 p, double d, const At& at) {
  constexpr double kStep = 1e-5;
  const glm::dvec2 by{at({p.x + kStep, p.y}) - d, at({p.x, p.y + kStep}) - d};
  const double length = glm::length(by);
  return length > 0.0 ? by / length : glm::dvec2{0.0};
}

}  // namespace mien
