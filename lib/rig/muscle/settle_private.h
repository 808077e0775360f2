#pragma once
// Sticking to a tip of the energy. A point caught there rings through the tip ever faster and ever
// less, without end: once it can no longer come farther from it than `reach`, it is put there.

#include "lib/rig/muscle/law.h"
#include "step_private.h"

namespace mien {

/// Of the face's size: how near a tip a caught point is put onto it.
inline constexpr double kSettleReach = 2e-9;

/// How much more the tips at `origin` hold than the other forces there pull; negative: no sticking.
double tip_margin(const MusclePointLaw& law, glm::dvec2 origin);

void settle_on_tip(const MusclePointLaw& law, double reach, MuscleState& s);

}  // namespace mien
