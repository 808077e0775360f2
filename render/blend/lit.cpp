#include "render/blend/lit.h"
#include "render/blend/transfer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

Lamp::Lamp(const Light& light, double specular, double shininess)
    : to_lamp_{0.0, 0.0, 1.0},
      ambient_(std::clamp(light.ambient, 0.0, 1.0)),
      specular_(std::clamp(specular, 0.0, 1.0)),
      shininess_(shininess) {
  const double length = glm::length(light.direction);
  if (light.direction.z > 0.0 && std::isfinite(length)) to_lamp_ = light.direction / length;
  halfway_ = glm::normalize(to_lamp_ + glm::dvec3{0.0, 0.0, 1.0});
  level_shine_ = std::pow(halfway_.z, shininess_);
}

Mix Lamp::lit(const Mix& color, glm::dvec2 slope, Blend blend) const {
  if (slope == glm::dvec2{0.0} || !(color.a > 0.0)) return color;
  // n = (−slope, 1) / length
  const double length = std::sqrt(1.0 + (slope.x * slope.x + slope.y * slope.y));
  const auto facing = [&](const glm::dvec3& way) {
    return std::max(0.0, (way.z - (slope.x * way.x + slope.y * way.y)) / length);
  };
  const double diffuse = ambient_ + (1.0 - ambient_) * facing(to_lamp_) / to_lamp_.z;
  double shine = 0.0;
  if (specular_ > 0.0 && level_shine_ < 1.0) {
    const double s = std::pow(facing(halfway_), shininess_);
    shine = specular_ * std::max(0.0, (s - level_shine_) / (1.0 - level_shine_));
  }
  Mix out = color;
  for (int i = 0; i < 3; ++i) {
    const double c = color[i] / color.a, light = blend == Blend::linear ? c : linear_from_srgb(c);
    const double bright = std::clamp(light * diffuse + shine, 0.0, 1.0);
    out[i] = color.a * (blend == Blend::linear ? bright : srgb_from_linear(bright));
  }
  return out;
}

}  // namespace mien
