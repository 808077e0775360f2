#include "lib/rig/muscle/law.h"

#include <cmath>

namespace mien {
namespace {

double length(glm::dvec2 v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

glm::dvec2 point_at(const FaceVector& vector, const Layout& layout, int slice) {
  const auto begin = std::size_t(layout[slice].begin);
  return {vector[begin], vector[begin + 1]};
}

/// Sums by sides, none + (left + right), so that mirrored sides give the same bits.
template <class Value>
struct BySide {
  Value none{}, left{}, right{};
  Value& operator[](Side side) {
    return side == Side::none ? none : side == Side::left ? left : right;
  }
  Value sum() const { return none + (left + right); }
};

}  // namespace

void muscle_law(const FaceModel& model, const FaceVector& rest, const MusclePoint& point,
                std::span<const double> pulls, MusclePointLaw& law) {
  const MuscleSystem& system = model.muscles;
  law.rest = point_at(rest, model.layout, point.slice);
  law.stiffness = system.stiffness, law.damping = system.damping;
  law.on_axis = point.twin >= 0;
  law.springs.clear();
  const double share = law.on_axis ? 0.5 : 1;
  for (const MuscleHold& hold : point.holds) {
    const double pull = pulls[std::size_t(hold.muscle.at)];
    const Muscle& muscle = hold.muscle.in(system.muscles);
    const double stiffness = share * hold.weight * muscle.strength * pull;
    if (!(stiffness > 0)) continue;
    law.springs.push_back({muscle.origin, stiffness,
                           length(law.rest - muscle.origin) - muscle.stroke * pull, muscle.side});
  }
}

MuscleNumberLaw muscle_law(const FaceModel& model, const MuscleNumber& number,
                           std::span<const double> pulls) {
  const MuscleSystem& system = model.muscles;
  BySide<double> stiffness, force;
  for (const MuscleHold& hold : number.holds) {
    const double pull = pulls[std::size_t(hold.muscle.at)];
    const Muscle& muscle = hold.muscle.in(system.muscles);
    const double c = hold.weight * muscle.strength * pull;
    stiffness[muscle.side] += c;
    force[muscle.side] += c * hold.stroke * pull;
  }
  return {system.stiffness + stiffness.sum(), system.damping, force.sum()};
}

double muscle_energy(const MusclePointLaw& law, glm::dvec2 p) {
  const glm::dvec2 away = p - law.rest;
  BySide<double> energy;
  energy.none = 0.5 * law.stiffness * (away.x * away.x + away.y * away.y);
  for (const MuscleSpring& spring : law.springs) {
    const double stretch = length(p - spring.origin) - spring.free_length;
    energy[spring.side] += 0.5 * spring.stiffness * stretch * stretch;
  }
  return energy.sum();
}

glm::dvec2 muscle_force(const MusclePointLaw& law, glm::dvec2 p) {
  BySide<glm::dvec2> force;
  force.none = law.stiffness * (law.rest - p);
  double tip = 0;  // the largest force that a tip at p can hold
  for (const MuscleSpring& spring : law.springs) {
    const glm::dvec2 to_origin = spring.origin - p;
    const double distance = length(to_origin);
    if (distance > 0)
      force[spring.side] +=
          spring.stiffness * (distance - spring.free_length) / distance * to_origin;
    else if (spring.free_length < 0)
      tip -= spring.stiffness * spring.free_length;
  }
  glm::dvec2 sum = force.sum();
  if (law.on_axis) sum.x = 0;
  if (tip == 0) return sum;
  const double size = length(sum);
  return size <= tip ? glm::dvec2{0} : sum * (1 - tip / size);
}

MuscleStiffness muscle_stiffness(const MusclePointLaw& law, glm::dvec2 p) {
  BySide<double> xx, xy, yy;
  xx.none = yy.none = law.stiffness;
  for (const MuscleSpring& spring : law.springs) {
    const glm::dvec2 away = p - spring.origin;
    const double distance = length(away), c = spring.stiffness;
    if (!(distance > 0)) {
      xx[spring.side] += c, yy[spring.side] += c;
      continue;
    }
    // c along the spring, c (1 − L/r) across it.
    const glm::dvec2 u = away / distance;
    const double across = c * (1 - spring.free_length / distance), along = c - across;
    xx[spring.side] += across + along * u.x * u.x;
    yy[spring.side] += across + along * u.y * u.y;
    xy[spring.side] += along * u.x * u.y;
  }
  return {xx.sum(), xy.sum(), yy.sum()};
}

}  // namespace mien
