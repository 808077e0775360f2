#include "lib/rig/eye/blink.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace mien {

LidPair uncrossed(const LidPair& lids, glm::dvec2 up, double share) {
  const glm::dvec2 gap = lids.upper - lids.lower, along{up.y, -up.x};
  const double open = glm::dot(gap, up), slant = glm::dot(gap, along);
  if (open >= 0 && std::abs(slant) <= kMostSlant * open) return lids;
  const double kept_open = open > 0 ? open : 0;
  const double kept_slant = std::copysign(kMostSlant * kept_open, slant);
  const glm::dvec2 meeting = mixed(lids.upper, lids.lower, share);
  const glm::dvec2 kept = kept_open * up + kept_slant * along;
  if (kept == glm::dvec2(0)) return {meeting, meeting};
  return {meeting + share * kept, meeting - (1 - share) * kept};
}

}  // namespace mien
