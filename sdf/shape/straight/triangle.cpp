#include <mien/shape.h>
#include "sdf/shape/segment_private.h"

#include <algorithm>

namespace mien {
namespace {

/// Twice the area of a b p, positive if p is left of the way from a to b.
double left_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

}  // namespace

// The nearest of three segments; inside where all three sides agree with the way round. A triangle
// of no area has no inside.
double distance(const Triangle& s, glm::dvec2 p) {
  const double nearest =
      std::min({distance_to_segment(s.a, s.b, p), distance_to_segment(s.b, s.c, p),
                distance_to_segment(s.c, s.a, p)});
  const double way = left_of(s.a, s.b, s.c);
  const double ab = left_of(s.a, s.b, p), bc = left_of(s.b, s.c, p), ca = left_of(s.c, s.a, p);
  const bool inside = (way > 0.0 && ab >= 0.0 && bc >= 0.0 && ca >= 0.0) ||
                      (way < 0.0 && ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
  return outside_if_nan(inside ? -nearest : nearest);
}

}  // namespace mien
