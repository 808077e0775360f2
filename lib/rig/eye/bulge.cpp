#include "lib/rig/eye/bulge.h"

#include "lib/math/bracketed_root.h"

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

/// Halving by rank alone ends after 64 places, every third halves.
constexpr int kMostPlaces = 256;

/// How far beyond `far` the push (native) moves the point of a lid's edge that stands `reach` from the
/// ball's centre along the unit `ray`, with its slope in `reach`. The lid's direction leans s = reach over
/// the lid's radius to the side, so the push e v² is seen as e v² s.
ValueSlope pushed_beyond(const EyeBody& eye, glm::dvec2 ray, double reach, double far,
                         glm::dvec3 g) {
  const double s = reach / lid_radius(eye);
  const double noise = 0x1p-54 * far;
  const glm::dvec3 d = lid_direction(eye, eye.center + reach * ray);
  const double push = lid_push(eye, d, g);
  if (!(s < 1) || !(push > 0)) return {reach + push * std::min(s, 1.0) - far, 1, noise};
  const double v = std::sqrt(push / eye.bulge), steep = eye.radius / cap(eye);
  const double v_in_s = steep * (glm::dot(ray, glm::dvec2(g)) - s / d.z * g.z);
  const double slope = eye.bulge * v * (2 * v_in_s * s + v) / lid_radius(eye);
  return {reach + push * s - far, 1 + slope, noise};
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
  if (!(far > 0) || !(lid_push(eye, lid_direction(eye, p), g) > 0)) return p;
  const glm::dvec2 ray = (p - eye.center) / far;
  const auto beyond = [&](double reach) { return pushed_beyond(eye, ray, reach, far, g); };
  // The push goes outwards: before it the point is nearer.
  return eye.center + bracketed_root(beyond, 0, far, -1, far, kMostPlaces) * ray;
}

}  // namespace mien
