#include <mien/shape.h>
#include "sdf/shape/segment_private.h"

#include <cstddef>

namespace mien {

double distance(const Polyline& s, glm::dvec2 p) {
  if (s.points.empty()) return std::numeric_limits<double>::infinity();
  double nearest = distance_to_segment(s.points[0], s.points[0], p);
  for (std::size_t i = 1; i < s.points.size(); ++i)
    nearest = std::min(nearest, distance_to_segment(s.points[i - 1], s.points[i], p));
  return outside_if_nan(nearest - s.half_width);
}

}  // namespace mien
