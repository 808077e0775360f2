#pragma once
// Steps in time for one point that muscles hold: the explicit Runge-Kutta pair of orders 5 and 4 by
// Dormand and Prince (J. Comput. Appl. Math. 6, 1980), halving its step until the pair agrees.

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mien {

struct MuscleState {
  glm::dvec2 p{0}, v{0};
};

/// One step of length h from `s`: the state after it by order 5, and how far order 4 is from that.
///   acceleration   (time, p, v) → p''
template <class Acceleration>
MuscleState muscle_step(Acceleration& acceleration, double t, double h, const MuscleState& s,
                        double& error) {
  constexpr int kStages = 7;
  constexpr double kAt[kStages] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
  constexpr double kBy[kStages][kStages - 1] = {
      {},
      {1. / 5},
      {3. / 40, 9. / 40},
      {44. / 45, -56. / 15, 32. / 9},
      {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
      {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  constexpr double kOff[kStages] = {71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                    -17253. / 339200, 22. / 525, -1. / 40};  // order 5 − order 4
  glm::dvec2 dp[kStages], dv[kStages];
  MuscleState at = s;
  for (int stage = 0; stage < kStages; ++stage) {
    glm::dvec2 p{0}, v{0};
    for (int i = 0; i < stage; ++i) p += kBy[stage][i] * dp[i], v += kBy[stage][i] * dv[i];
    at = {s.p + h * p, s.v + h * v};
    dp[stage] = at.v;
    dv[stage] = acceleration(t + kAt[stage] * h, at.p, at.v);
  }
  glm::dvec2 off_p{0}, off_v{0};
  for (int i = 0; i < kStages; ++i) off_p += kOff[i] * dp[i], off_v += kOff[i] * dv[i];
  // A velocity error counts by the distance that it adds until damping has removed it, within about 1 s.
  error = h * std::max({std::abs(off_p.x), std::abs(off_p.y), 0.25 * std::abs(off_v.x),
                        0.25 * std::abs(off_v.y)});
  return at;  // the last stage is evaluated at the new state
}

/// Integrates from t0 to t1 in steps of a 2^n-th of that time, each as long as its error allows, and
/// returns their number. Where a force jumps, steps shrink to the finest, which takes some dozens. After
/// kMostSteps (a point oscillating about a tip of its energy faster than anybody could see) it goes on
/// without regard to errors. If the state is then no longer a number, it becomes the one at t0, at rest.
///   settle   (time, state) after each step; may change the state
template <class Acceleration, class Settle>
int muscle_steps(Acceleration&& acceleration, Settle&& settle, double t0, double t1,
                 double tolerance, MuscleState& s) {
  constexpr std::uint32_t kFinest = 1u << 17;
  constexpr int kMostSteps = 2048;
  const MuscleState begin = s;
  std::uint32_t at = 0, step = kFinest;
  int steps = 0;
  while (at < kFinest) {
    const double t = t0 + (t1 - t0) * (double(at) / kFinest);
    double error;
    const MuscleState next =
        muscle_step(acceleration, t, (t1 - t0) * (double(step) / kFinest), s, error);
    ++steps;
    if (!(error <= tolerance) && step > 1 && steps < kMostSteps) {
      step /= 2;
      continue;
    }
    s = next;
    at += step;
    settle(t0 + (t1 - t0) * (double(at) / kFinest), s);
    while (step < kFinest && at % (2 * step) == 0 &&
           (error < tolerance / 64 || steps >= kMostSteps))
      step *= 2, error *= 32;
  }
  if (!std::isfinite(s.p.x + s.p.y + s.v.x + s.v.y)) s = {begin.p, {0, 0}};
  return steps;
}

}  // namespace mien
