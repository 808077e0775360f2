#include "lib/rig/eye/gaze.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace mien {

glm::dvec2 within_reach(glm::dvec2 shift, glm::dvec2 reach) {
  if (!(reach.x > 0)) shift.x = 0, reach.x = 1;
  if (!(reach.y > 0)) shift.y = 0, reach.y = 1;
  const double far = std::hypot(shift.x / reach.x, shift.y / reach.y);
  return far > 1 ? shift / far : shift;
}

glm::dvec2 gaze_shift(glm::dvec3 center, double radius, glm::dvec2 reach, glm::dvec3 target) {
  const glm::dvec3 way = target - center;
  const double aside = std::hypot(way.x, way.y);
  const double length = way.z < 0 ? aside : std::hypot(aside, way.z);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0};
  const glm::dvec2 shift = radius * (glm::dvec2(way.x, way.y) / length);
  return within_reach(shift, {std::min(reach.x, radius), std::min(reach.y, radius)});
}

glm::dvec3 gaze_axis(glm::dvec2 shift, double radius) {
  if (!(radius > 0)) return {0, 0, 1};
  glm::dvec2 aside = shift / radius;
  const double far = glm::dot(aside, aside);
  if (!(far < 1)) {
    aside = far > 1 && std::isfinite(far) ? aside / std::sqrt(far) : glm::dvec2(0);
    return {aside, far > 1 ? 0.0 : 1.0};
  }
  return {aside, std::sqrt(1 - far)};
}

}  // namespace mien
