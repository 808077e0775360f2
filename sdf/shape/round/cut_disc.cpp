#include <mien/shape.h>
#include "lib/math/norm.h"
#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

// Both chords lie on their own side of the centre, so the shape is convex and only the chord on p's
// side matters outside: p is nearest to that chord, to a corner, or to the arc. Inside a convex
// shape the distance is that to the nearest of the circle and the two chord lines.
//
//            corner
//     _________.  .   p
//    /  chord  \           v up
//   /           \          u across
//   |     +     |  arc
double distance(const CutDisc& s, glm::dvec2 p) {
  const glm::dvec2 q = p - s.center;
  double v = glm::dot(q, s.up), near_cut = s.upper, far_cut = s.lower;
  const double u = std::abs(s.up.x * q.y - s.up.y * q.x), r = s.radius, from_center = norm(q);
  if (v < 0.0) {
    v = -v;
    std::swap(near_cut, far_cut);
  }
  const double to_circle = from_center - r;
  if (near_cut >= 1.0 && (far_cut >= 1.0 || to_circle > 0.0)) return outside_if_nan(to_circle);
  const double to_near = near_cut < 1.0 ? v - near_cut * r : to_circle;
  if (to_circle <= 0.0 && to_near <= 0.0)
    return std::max({to_circle, to_near, far_cut < 1.0 ? -v - far_cut * r : to_circle});
  const double half_chord = r * std::sqrt((1.0 - near_cut) * (1.0 + near_cut));
  if (u <= half_chord) return outside_if_nan(to_near > 0.0 ? to_near : to_circle);
  if (v <= near_cut * from_center) return outside_if_nan(to_circle);
  return outside_if_nan(norm({u - half_chord, to_near}));
}

}  // namespace mien
