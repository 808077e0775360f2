#include "settle_private.h"

#include <cmath>

namespace mien {

double tip_margin(const MusclePointLaw& law, glm::dvec2 origin) {
  glm::dvec2 others = law.stiffness * (law.rest - origin);
  double tip = 0;
  for (const MuscleSpring& spring : law.springs) {
    const glm::dvec2 to = spring.origin - origin;
    const double distance = std::sqrt(to.x * to.x + to.y * to.y);
    if (distance > 0)
      others += spring.stiffness * (distance - spring.free_length) / distance * to;
    else if (spring.free_length < 0)
      tip -= spring.stiffness * spring.free_length;
  }
  if (law.on_axis) others.x = 0;
  return tip - std::sqrt(others.x * others.x + others.y * others.y);
}

void settle_on_tip(const MusclePointLaw& law, double reach, MuscleState& s) {
  for (const MuscleSpring& spring : law.springs) {
    if (spring.free_length >= 0) continue;
    const glm::dvec2 off = s.p - spring.origin;
    const double distance2 = off.x * off.x + off.y * off.y;
    if (!(distance2 < reach * reach) || (law.on_axis && spring.origin.x != s.p.x)) continue;
    const double margin = tip_margin(law, spring.origin);
    const double motion = 0.5 * (s.v.x * s.v.x + s.v.y * s.v.y);
    if (margin > 0 && motion + margin * std::sqrt(distance2) < margin * reach)
      s = {spring.origin, {0, 0}};
  }
}

}  // namespace mien
