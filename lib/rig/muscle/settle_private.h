#pragma once
// Sticking to a tip of the energy. A caught point oscillates through the tip faster and faster, by less and
// less, without end. Once it can no longer come farther from the tip than `reach`, it is put there.

#include "lib/rig/muscle/law.h"
#include "step_private.h"

namespace mien {

/// The distance from a tip at which a caught point is put onto it, as a share of the face's size.
inline constexpr double kSettleReach = 2e-9;

/// The force that the tips at `origin` can hold, less the other forces there; negative: no sticking.
double tip_margin(const MusclePointLaw& law, glm::dvec2 origin);

void settle_on_tip(const MusclePointLaw& law, double reach, MuscleState& s);

}  // namespace mien
