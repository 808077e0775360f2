#include <mien/shape.h>
#include "sdf/shape/segment_private.h"

#include <glm/geometric.hpp>

namespace mien {

// Exact to rounding: 2·2⁻⁵²·(|p| + |offset|).
double distance(const HalfPlane& s, glm::dvec2 p) {
  return outside_if_nan(glm::dot(p, s.normal) - s.offset);
}

}  // namespace mien
