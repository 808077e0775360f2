#include "lib/rig/muscle/equilibrium.h"

#include "settle_private.h"
#include "step_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace mien {
namespace {

constexpr double kRounding = 1e-12;  ///< relative, of an energy; a safe bound

double squared(glm::dvec2 v) {
  return v.x * v.x + v.y * v.y;
}

/// −H⁻¹ times the gradient, with H made positive definite if it is not; only up or down for a point on the
/// axis.
glm::dvec2 newton_step(const MusclePointLaw& law, glm::dvec2 p, glm::dvec2 force) {
  const MuscleStiffness h = muscle_stiffness(law, p);
  const double floor = 0.1 * law.stiffness;
  if (law.on_axis) return {0, force.y / std::max(h.yy, floor)};
  const double mean = 0.5 * (h.xx + h.yy), half = 0.5 * (h.xx - h.yy);
  const double least = mean - std::sqrt(half * half + h.xy * h.xy);
  const double more = least < floor ? floor - least : 0;
  const double xx = h.xx + more, yy = h.yy + more, over = 1 / (xx * yy - h.xy * h.xy);
  return {(yy * force.x - h.xy * force.y) * over, (xx * force.y - h.xy * force.x) * over};
}

/// A tip of the energy that `step` passes and near which the point would stick; null: none.
const MuscleSpring* tip_passed(const MusclePointLaw& law, glm::dvec2 p, glm::dvec2 step) {
  for (const MuscleSpring& spring : law.springs) {
    if (spring.free_length >= 0 || (law.on_axis && spring.origin.x != p.x)) continue;
    const glm::dvec2 to = spring.origin - p;
    if (squared(to) <= squared(step) && tip_margin(law, spring.origin) >= 0) return &spring;
  }
  return nullptr;
}

/// Leaves a tip that does not hold the point but is so near that Newton's method sees nothing else: steps
/// along the excess of the other forces over the tip's. Returns whether it did.
bool leap_off_tip(const MusclePointLaw& law, double size, glm::dvec2& p, double& energy) {
  constexpr double kNear = 1e-2;
  for (const MuscleSpring& spring : law.springs) {
    if (spring.free_length >= 0 || (law.on_axis && spring.origin.x != p.x) ||
        squared(p - spring.origin) > kNear * kNear * size * size)
      continue;
    double stiffness = law.stiffness;
    for (const MuscleSpring& each : law.springs) stiffness += each.stiffness;
    glm::dvec2 by = muscle_force(law, spring.origin) / stiffness;
    for (int halvings = 0; halvings < 60; ++halvings, by *= 0.5) {
      const double there = muscle_energy(law, spring.origin + by);
      if (there < energy && by != glm::dvec2{0}) {
        p = spring.origin + by, energy = there;
        return true;
      }
    }
  }
  return false;
}

/// A minimum of the energy, searched from `p`: steps that decrease it sufficiently, then full steps once
/// they are so small that rounding hides their gain.
glm::dvec2 minimum_from(const MusclePointLaw& law, glm::dvec2 p, double size) {
  double energy = muscle_energy(law, p);
  int last_steps = 0, leaps = 0;
  for (int step = 0; step < 60 && last_steps < 4; ++step) {
    if (leaps < 8 && leap_off_tip(law, size, p, energy)) ++leaps;
    const glm::dvec2 force = muscle_force(law, p);
    glm::dvec2 by = newton_step(law, p, force);
    const double length = std::sqrt(squared(by));
    if (!(length > 1e-15 * size)) return p;
    if (const MuscleSpring* tip = tip_passed(law, p, by))
      if (muscle_energy(law, tip->origin) <= energy) return tip->origin;
    if (length < 1e-6 * size) {
      p += by, ++last_steps;
      continue;
    }
    const double fall = force.x * by.x + force.y * by.y;
    double share = 1, there = muscle_energy(law, p + by);
    while (there > energy - 1e-4 * share * fall && share > 1e-9)
      share *= 0.5, there = muscle_energy(law, p + share * by);
    p += share * by, energy = there;
  }
  return p;
}

/// A lower bound of the energy's second derivatives in the disc about q.
double least_stiffness(const MusclePointLaw& law, glm::dvec2 q, double radius) {
  double least = law.stiffness;
  for (const MuscleSpring& spring : law.springs) {
    const double nearest = std::sqrt(squared(q - spring.origin)) - radius;
    if (spring.free_length <= 0)
      least += spring.stiffness;
    else if (nearest <= 0)
      return -1;
    else
      least += spring.stiffness * std::min(1.0, 1 - spring.free_length / nearest);
  }
  return least;
}

/// Whether E is strongly convex in a disc about q that a point at p with this total energy cannot leave.
bool bound_by_disc(const MusclePointLaw& law, glm::dvec2 q, glm::dvec2 p, double energy,
                   double size) {
  const double distance = std::sqrt(squared(p - q));
  const double above = energy - muscle_energy(law, q) + kRounding * energy;
  const auto proven = [&](double radius) {
    return above < 0.5 * least_stiffness(law, q, radius) * radius * radius;
  };
  for (const double times : {1.01, 1.3, 2.0})
    if (proven(times * distance)) return true;
  for (const double part : {1e-4, 1e-2})
    if (part * size > distance && proven(part * size)) return true;
  return false;
}

/// E made convex: within `blunt[m]` of its origin, spring m's energy is continued with the same slope by
/// the paraboloid whose second derivatives are those that the spring has across itself there.
struct BluntEnergy {
  const MusclePointLaw& law;
  std::span<const double> blunt;

  double operator()(glm::dvec2 x, glm::dvec2& gradient) const {
    gradient = law.stiffness * (x - law.rest);
    double energy = 0.5 * law.stiffness * squared(x - law.rest);
    for (std::size_t m = 0; m < law.springs.size(); ++m) {
      const MuscleSpring& spring = law.springs[m];
      const glm::dvec2 away = x - spring.origin;
      const double r2 = squared(away), edge = blunt[m];
      const double r = std::max(std::sqrt(r2), edge), stretch = r - spring.free_length;
      energy += 0.5 * spring.stiffness * stretch * stretch;
      if (!(r > 0)) continue;
      const double slope = spring.stiffness * stretch / r;
      gradient += slope * away;
      if (r2 < edge * edge) energy += 0.5 * slope * (r2 - edge * edge);
    }
    if (law.on_axis) gradient.x = 0;
    return energy;
  }
};

/// Whether the point lacks the energy to come near any origin, where E is not convex. Then E is convex
/// wherever the point can come, and q is its only minimum there.
///
/// Near its origin, a spring with L > 0 has a negative stiffness across itself, c (1 − L/r). Each of them
/// may use up an equal part of the stiffness that is certain, k and the c of springs with L <= 0. Only
/// within a disc about its origin it would use more. There E is made blunt, which makes it convex
/// everywhere; and a convex function with a tangent at y is at least f(y) + ∇f · (x − y).
bool bound_by_origins(const MusclePointLaw& law, glm::dvec2 p, double energy) {
  constexpr std::size_t kMost = 32;
  if (law.springs.size() > kMost) return false;
  double sure = law.stiffness;
  int soft = 0;
  for (const MuscleSpring& spring : law.springs)
    if (spring.free_length > 0)
      ++soft;
    else
      sure += spring.stiffness;
  std::array<double, kMost> edges{};
  const double part = 0.99 * sure / std::max(soft, 1);
  for (std::size_t m = 0; m < law.springs.size(); ++m)
    if (const MuscleSpring& spring = law.springs[m]; spring.free_length > 0)
      edges[m] = spring.free_length / (1 + part / spring.stiffness);
  const BluntEnergy blunt{law, {edges.data(), law.springs.size()}};
  for (std::size_t m = 0; m < law.springs.size(); ++m) {
    const double edge = edges[m];
    const glm::dvec2 origin = law.springs[m].origin;
    if (!(edge > 0)) continue;
    if (squared(p - origin) <= edge * edge) return false;
    // The tangent at the disc's edge towards p, then where that tangent was least.
    glm::dvec2 y = origin + edge / std::sqrt(squared(p - origin)) * (p - origin);
    bool out_of_reach = false;
    for (int turn = 0; turn < 4 && !out_of_reach; ++turn) {
      glm::dvec2 gradient;
      const double at_y = blunt(y, gradient), slope = std::sqrt(squared(gradient));
      const glm::dvec2 to = origin - y;
      out_of_reach =
          at_y + gradient.x * to.x + gradient.y * to.y - slope * edge > energy * (1 + kRounding);
      if (slope == 0) break;
      const glm::dvec2 least = origin - edge / slope * gradient;
      y = turn == 0 ? least : 0.5 * (y + least);
    }
    if (!out_of_reach) return false;
  }
  return true;
}

/// The equilibrium that the point reaches from rest: it is followed in time until it can come to rest in
/// one place only.
glm::dvec2 followed(const MusclePointLaw& law, double size) {
  double stiffness = law.stiffness;
  for (const MuscleSpring& spring : law.springs) stiffness += spring.stiffness;
  const double cell = std::min(1. / 8, 1 / std::sqrt(stiffness));
  const auto acceleration = [&](double, glm::dvec2 p, glm::dvec2 v) {
    return muscle_force(law, p) - law.damping * v;
  };
  const double reach = kSettleReach * size;
  const auto settle = [&](double, MuscleState& s) { settle_on_tip(law, reach, s); };
  constexpr int kMostSteps = 1 << 13;
  constexpr double kTolerance = 1e-4;  // which minimum it leads to matters, not the exact path
  MuscleState s{law.rest, {0, 0}};
  for (int i = 1, steps = 0; steps < kMostSteps; ++i) {
    steps += muscle_steps(acceleration, settle, 0, cell, kTolerance * size, s);
    const double energy = muscle_energy(law, s.p) + 0.5 * squared(s.v);
    if (bound_by_origins(law, s.p, energy)) break;
    if (i % 16 == 0 && bound_by_disc(law, minimum_from(law, s.p, size), s.p, energy, size)) break;
  }
  return minimum_from(law, s.p, size);
}

}  // namespace

MuscleEquilibrium muscle_equilibrium(const MusclePointLaw& law) {
  if (law.springs.empty()) return {law.rest, true};
  double size = 0;
  for (const MuscleSpring& spring : law.springs)
    size = std::max(size, std::sqrt(squared(spring.origin - law.rest)));
  const double energy = muscle_energy(law, law.rest);
  if (bound_by_origins(law, law.rest, energy)) return {minimum_from(law, law.rest, size), true};
  const glm::dvec2 q = minimum_from(law, law.rest, size);
  if (bound_by_disc(law, q, law.rest, energy, size)) return {q, true};
  return {followed(law, size), false};
}

}  // namespace mien
