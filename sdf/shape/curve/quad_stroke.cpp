#include <mien/quad_bezier_distance.h>
#include <mien/shape.h>
#include "sdf/shape/segment_private.h"

namespace mien {

double distance(const QuadStroke& s, glm::dvec2 p) {
  return outside_if_nan(distance(s.spine, p) - s.half_width);
}

}  // namespace mien
