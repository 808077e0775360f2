#include "lib/rig/eye/bulge.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mien {
namespace {

bool has_cornea(const EyeBody& eye) {
  return eye.radius > 0 && eye.cornea > 0 && eye.bulge != 0;
}

/// The cap's height, never beyond the ball's front half.
double cap(const EyeBody& eye) {
  return std::min(eye.cornea, eye.radius);
}

}  // namespace

double lid_push(const EyeBody& eye, glm::dvec3 d, glm::dvec3 g) {
  if (!has_cornea(eye)) return 0;
  const double h = cap(eye);
  if (eye.law == BulgeLaw::compat) {
    const double a = std::sqrt(h * (2 * eye.radius - h));
    return eye.bulge * std::max(0.0, a - std::min(1.0, glm::length(d - g)));
  }
  const double v = 1 - (1 - glm::dot(d, g)) * (eye.radius / h);
  return v > 0 ? eye.bulge * v * v : 0;
}

glm::dvec3 lid_direction(const EyeBody& eye, glm::dvec2 p) {
  const glm::dvec2 aside = (p - eye.center) / lid_radius(eye);
  const double far = glm::dot(aside, aside);
  if (far < 1) return {aside, std::sqrt(1 - far)};
  return {aside / std::sqrt(far), 0};
}

glm::dvec2 edge_push(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g) {
  if (!has_cornea(eye)) return {0, 0};
  const glm::dvec3 d = lid_direction(eye, p);
  const double push = lid_push(eye, d, g);
  if (!(push != 0)) return {0, 0};
  return push * (eye.law == BulgeLaw::compat ? glm::dvec2(g) : glm::dvec2(d));
}

double lid_rise(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g) {
  if (!has_cornea(eye)) return 0;
  const glm::dvec3 d = lid_direction(eye, p);
  return lid_push(eye, d, g) * (eye.law == BulgeLaw::compat ? g.z : d.z);
}

CorneaDome cornea_dome(const EyeBody& eye, glm::dvec3 g) {
  const double h = cap(eye), a = std::sqrt(h * (2 * eye.radius - h));
  const glm::dvec2 aside{g.x, g.y};
  CorneaDome dome{.center = eye.center + (eye.radius - 0.5 * h) * aside,
                  .radii = {a * g.z, a},
                  .height = eye.bulge * g.z,
                  .tilt = 0};
  if (g.x == 0 && g.y == 0) return dome;
  const bool level = std::abs(g.x) >= std::abs(g.y);
  if (!level) std::swap(dome.radii.x, dome.radii.y);
  dome.tilt = std::atan(level ? g.y / g.x : 0 - g.x / g.y) * 180 / std::numbers::pi;
  return dome;
}

double most_bulge(double radius, double cornea) {
  return cornea * radius / (radius - cornea);
}

glm::dvec2 standing_place(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g) {
  if (!has_cornea(eye)) return p;
  if (eye.law == BulgeLaw::compat) return p - edge_push(eye, p, g);
  const double far = glm::length(p - eye.center);
  const auto at = [&](double reach) { return eye.center + reach / far * (p - eye.center); };
  double lo = 0, hi = far;  // the push goes outwards: before it the point is nearer
  for (int i = 0; i < 60 && far > 0; ++i) {
    const double reach = 0.5 * (lo + hi);
    (reach + glm::length(edge_push(eye, at(reach), g)) < far ? lo : hi) = reach;
  }
  return far > 0 ? at(0.5 * (lo + hi)) : p;
}

}  // namespace mien
