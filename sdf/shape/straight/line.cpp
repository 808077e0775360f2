#include <mien/shape.h>
#include "sdf/shape/segment_private.h"

namespace mien {

double distance(const Line& s, glm::dvec2 p) {
  return outside_if_nan(distance_to_segment(s.a, s.b, p) - s.half_width);
}

}  // namespace mien
