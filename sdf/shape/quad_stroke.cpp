#include <mien/sdf/shape/quad_bezier.h>
#include <mien/sdf/shape/shape.h>
#include "segment_private.h"

namespace mien {

double distance(const QuadStroke& s, glm::dvec2 p) {
  return outside_if_nan(distance(s.spine, p) - s.half_width);
}

}  // namespace mien
