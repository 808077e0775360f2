#pragma once
// Where muscles leave a face: the equilibrium that is reached from rest when all pulls are applied at
// once and held.
//
// Solved directly, point by point (points do not act on each other): Newton's method on the energy,
// from rest, safeguarded by it. That gives A minimum of the energy; it is THE one if no other can be
// reached: a point that starts at rest never has more energy than E(p0), and if E is strongly convex
// in a disc about the minimum q, E'' ≥ μ there, it stays in the part of the disc of radius ρ that it
// begins in whenever E(p0) − E(q) < μ ρ²/2. Where this proof fails (strong muscles pulling past their
// origins), the motion is followed in time until it succeeds from there.
//
// Error: 1e-12 of the canvas's longer side, or 1e-13 of the coordinates; measured against long
// simulations in tests/lib/rig/muscle/equilibrium_test.cpp.

#include "lib/rig/muscle/law.h"

namespace mien {

struct MuscleEquilibrium {
  glm::dvec2 p;
  bool proven;  ///< at rest: without following the motion
};

MuscleEquilibrium muscle_equilibrium(const MusclePointLaw& law);

/// Of a number: how far from rest.
inline double muscle_equilibrium(const MuscleNumberLaw& law) {
  return law.pull / law.stiffness;
}

}  // namespace mien
