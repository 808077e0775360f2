#include <mien/lib/math/norm.h>
#include <mien/sdf/shape/shape.h>
#include "segment_private.h"

namespace mien {

double distance(const Disc& s, glm::dvec2 p) {
  return outside_if_nan(norm(p - s.center) - s.radius);
}

}  // namespace mien
