#pragma once
// The eye under its lids: a ball and the cornea, part of a sphere through the cornea's rim.

#include "lib/rig/eye/bulge.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace mien::test {

/// Distance of the surface from the ball's centre, in direction `d`, for a cornea that stands
/// `eye.bulge` above the ball, or as much as it can.
inline double eye_surface(const EyeBody& eye, glm::dvec3 d, glm::dvec3 g) {
  const double R = eye.radius, h = std::min(eye.cornea, R), c = glm::dot(d, g);
  const double rim = 1 - h / R;  // cos α
  if (c <= rim) return R;
  // The sphere through the rim and the apex: centre k along the axis, radius r.
  const double apex = R + std::min(eye.bulge, most_bulge(R, h));
  const double k = (apex * apex - R * R) / (2 * (apex - R * rim)), r = apex - k;
  return k * c + std::sqrt(std::max(0.0, r * r - k * k * (1 - c * c)));
}

/// How far a point of a lid's edge that stands at `standing` and is drawn at `drawn` is outside of the
/// eye in its direction, as seen in the picture.
inline double lid_clearance(const EyeBody& eye, glm::dvec2 standing, glm::dvec2 drawn,
                            glm::dvec3 g) {
  const glm::dvec3 d = lid_direction(eye, standing);
  const double aside = glm::length(glm::dvec2(d));
  if (!(aside > 0)) return 0;
  return glm::dot(drawn - eye.center, glm::dvec2(d) / aside) - eye_surface(eye, d, g) * aside;
}

}  // namespace mien::test
