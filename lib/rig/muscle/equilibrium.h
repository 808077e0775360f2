#pragma once
// The equilibrium of a face under its muscles: where it comes to rest if all pulls are applied at once and
// held.
//
// It is solved directly, point by point (points do not act on each other): Newton's method on the energy,
// from rest, safeguarded to decrease it. That gives a minimum of the energy. It is the right one if the
// point can reach no other. A point that starts at rest never has more energy than E(p0). If E is strongly
// convex in a disc of radius ρ about the minimum q, E'' ≥ μ there, a point in the disc cannot leave it
// while E(p0) − E(q) < μ ρ²/2. Where this proof fails (strong muscles pulling past their origins), the
// motion is followed in time until it succeeds from there.
//
// Error: 1e-12 of the canvas's longer side, or 1e-13 of the coordinates; measured against long
// simulations in tests/lib/rig/muscle/equilibrium_test.cpp.

#include "lib/rig/muscle/law.h"

namespace mien {

struct MuscleEquilibrium {
  glm::dvec2 p;
  bool proven;  ///< whether the proof succeeded at rest, without following the motion
};

MuscleEquilibrium muscle_equilibrium(const MusclePointLaw& law);

/// The same of a number: how far it is from rest.
inline double muscle_equilibrium(const MuscleNumberLaw& law) {
  return law.pull / law.stiffness;
}

}  // namespace mien
