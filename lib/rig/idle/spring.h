#pragma once
// Damped springs, let go at rest, on the way to a new place.

#include "lib/math/degrees.h"

#include <cmath>
#include <numbers>

namespace mien {

/// e^−x for x from 0 to 8, within 1e-8 of it, by products alone: the same bits on every machine. Taylor's series to the
/// sixth power at x/64, to the 64th power.
constexpr double fall_of(double x) {
  const double h = -x / 64;
  double base = 1 + h * (1 + h / 2 * (1 + h / 3 * (1 + h / 4 * (1 + h / 5 * (1 + h / 6)))));
  for (int i = 0; i < 6; ++i) base *= base;
  return base;
}

struct Spring {
  double frequency;  ///< [rad/s] of the undamped spring
  double damping;    ///< share of the critical damping, below 1

  /// The share of a way that is left after `time` [s]: 1 before it begins. It overshoots by e^(−π d/√(1 − d²)).
  double left(double time) const {
    if (!(time > 0)) return 1;
    if (time >= settling()) return 0;
    const double ring = frequency * std::sqrt(1 - damping * damping), decay = frequency * damping;
    const glm::dvec2 turn = direction_at(ring * time * (180 / std::numbers::pi));
    return fall_of(decay * time) * (turn.x + decay / ring * turn.y);
  }

  /// [s] From then on, when less than 1/3000 is left, it is where it goes.
  constexpr double settling() const { return 8 / (frequency * damping); }
};

}  // namespace mien
