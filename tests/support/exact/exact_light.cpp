#include "tests/support/exact/exact_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::test {
namespace {

/// The derivative of the profile by x = distance inside / width.
double profile_slope(const Relief& relief, double x) {
  constexpr double kSteepest = 1e-14;  // of x: upright at the outline itself, yet finite
  if (x < 0 || x >= 1) return 0;
  switch (relief.profile) {
    case Profile::flat:
      return 0;
    case Profile::bevel:
      return 1;
    case Profile::round: {
      const double in = std::max(x, kSteepest);
      return (1 - in) / std::sqrt(in * (2 - in));
    }
    case Profile::custom:
      break;
  }
  const int steps = int(relief.table.size()) - 1, i = std::min(int(x * steps), steps - 1);
  return steps * (relief.table[std::size_t(i) + 1] - relief.table[std::size_t(i)]);
}

glm::dvec2 dome_slope(const Dome& dome, glm::dvec2 p) {
  const glm::dvec2 m = p - dome.center, across{-dome.axis.y, dome.axis.x};
  const double u = glm::dot(m, dome.axis) / dome.radii.x, v = glm::dot(m, across) / dome.radii.y;
  const double rest = 1 - (u * u + v * v);
  if (rest <= 0) return {0, 0};
  // height · rest²; its derivative by u is −4 · height · rest · u
  return -4 * dome.height * rest * (u / dome.radii.x * dome.axis + v / dome.radii.y * across);
}

glm::dvec2 slope_from(const ExactDistance& distance, Area area, glm::dvec2 p, double here,
                      double step) {
  const double right = distance(area, p + glm::dvec2{step, 0}),
               up = distance(area, p + glm::dvec2{0, step});
  return glm::dvec2{right - here, up - here} / step;
}

/// The law's terms before they are clamped.
struct Terms {
  double facing;     ///< the lamp
  double highlight;  ///< of its strength
  double ambient, to_front, strength;
};

Terms terms_of(glm::dvec2 slope, const Light& light, const Relief& relief) {
  const glm::dvec3 z{0, 0, 1};
  const bool from_the_front = light.direction.z > 0;
  const glm::dvec3 l = from_the_front ? glm::normalize(light.direction) : z;
  const glm::dvec3 h = glm::normalize(l + z), n = glm::normalize(glm::dvec3{-slope, 1});
  Terms t{glm::dot(n, l), 0, std::clamp(light.ambient, 0.0, 1.0), l.z,
          std::clamp(relief.specular, 0.0, 1.0)};
  const double level = std::pow(h.z, relief.shininess);
  if (t.strength > 0 && level < 1)
    t.highlight = (std::pow(std::max(0.0, glm::dot(n, h)), relief.shininess) - level) / (1 - level);
  return t;
}

glm::dvec3 unclamped(const glm::dvec3& color, const Terms& t) {
  const double diffuse = t.ambient + (1 - t.ambient) * std::max(0.0, t.facing) / t.to_front;
  return color * diffuse + t.strength * std::max(0.0, t.highlight);
}

}  // namespace

glm::dvec2 distance_slope(const ExactDistance& distance, Area area, glm::dvec2 p, double step) {
  return slope_from(distance, area, p, distance(area, p), step);
}

glm::dvec2 surface_slope(const ExactDistance& distance, const Relief& relief, glm::dvec2 p,
                         double step) {
  glm::dvec2 slope{0.0};
  if (relief.area.node >= 0 && relief.profile != Profile::flat && relief.height != 0) {
    const double d = distance(relief.area, p),
                 rise = relief.height / relief.width * profile_slope(relief, -d / relief.width);
    if (rise != 0) slope -= rise * slope_from(distance, relief.area, p, d, step);
  }
  for (const Dome& dome : relief.domes) slope += dome_slope(dome, p);
  return slope;
}

glm::dvec3 lit(const glm::dvec3& color, glm::dvec2 slope, const Light& light,
               const Relief& relief) {
  return glm::clamp(unclamped(color, terms_of(slope, light, relief)), 0.0, 1.0);
}

unsigned clamps(const glm::dvec3& color, glm::dvec2 slope, const Light& light,
                const Relief& relief) {
  const Terms t = terms_of(slope, light, relief);
  const glm::dvec3 bright = unclamped(color, t);
  return unsigned(t.facing < 0) + 2 * unsigned(t.highlight < 0) + 4 * unsigned(bright.r > 1) +
         8 * unsigned(bright.g > 1) + 16 * unsigned(bright.b > 1);
}

}  // namespace mien::test
