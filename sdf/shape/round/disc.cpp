#include <mien/shape.h>
#include "lib/math/norm.h"
#include "sdf/shape/segment_private.h"

namespace mien {

double distance(const Disc& s, glm::dvec2 p) {
  return outside_if_nan(norm(p - s.center) - s.radius);
}

}  // namespace mien
