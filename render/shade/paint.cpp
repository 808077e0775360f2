#include "render/shade/paint.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

double PaintField::at(glm::dvec2 p, double d) const {
  switch (kind) {
    case Kind::linear:
      return glm::dot(p, across) + shift;
    case Kind::radial:
      return glm::length(unit * (p - center));
    case Kind::distance:
      return (d - from) * scale;
  }
  return 0.0;
}

double PaintField::mean(glm::dvec2 p, double variance) const {
  if (kind != Kind::radial) return at(p, 0.0);
  const glm::dvec2 q = unit * (p - center), gradient = glm::transpose(unit) * q;
  const double tt = glm::dot(q, q), trace = glm::dot(unit[0], unit[0]) + glm::dot(unit[1], unit[1]);
  const double bends = trace - glm::dot(gradient, gradient) / std::max(tt, 1e-30);
  return std::sqrt(std::max(tt + variance * bends, 0.0));
}

RampPlane PaintField::plane(glm::dvec2 p, double variance) const {
  if (kind != Kind::radial) return {at(p, 0.0), across.x, across.y};
  const glm::dvec2 q = unit * (p - center);
  const double t = std::max(glm::length(q), 1e-300);
  const glm::dvec2 slope = glm::transpose(unit) * q / t;
  return {mean(p, variance), slope.x, slope.y};
}

/// Along its level line t bends by |Uτ|² / t, which level lines make up for by 1 / |∇t|.
double PaintField::bend(glm::dvec2 p) const {
  if (kind != Kind::radial) return 0.0;
  const glm::dvec2 q = unit * (p - center), slope = glm::transpose(unit) * q;  // times t
  const double steep = glm::length(slope);
  if (!(steep > 0.0)) return HUGE_VAL;
  const glm::dvec2 along = unit * (glm::dvec2{-slope.y, slope.x} / steep);
  return glm::dot(along, along) / steep;
}

double GridRelief::rise(double inside) const {
  // A hundredth of a pixel beyond the outline still counts as the outline: what is painted there is
  // inside, and only the local form of its distance says otherwise.
  constexpr double kOutline = 0.01;
  if (inside < -kOutline || inside >= width) return 0.0;
  const double x = std::max(inside, 0.0) / width, per_pixel = height / width;
  switch (profile) {
    case Profile::flat:
      return 0.0;
    case Profile::bevel:
      return per_pixel;
    case Profile::round: {
      constexpr double kSteepest = 1e-9;  // of x: upright at the outline itself, but finite
      const double out = 1.0 - std::max(x, kSteepest);
      return per_pixel * out / std::sqrt(1.0 - out * out);
    }
    case Profile::custom: {
      const double steps = double(table.size()) - 1.0;
      const auto i = std::min(std::size_t(x * steps), table.size() - 2);
      return per_pixel * steps * (table[i + 1] - table[i]);
    }
  }
  return 0.0;
}

glm::dvec2 GridRelief::slope(glm::dvec2 p, double d, glm::dvec2 gradient) const {
  glm::dvec2 rises{0.0};
  if (distance >= 0) rises = -rise(-d) * gradient;
  for (const GridDome& dome : domes) {
    const glm::dvec2 q = dome.unit * (p - dome.center);
    const double in = 1.0 - glm::dot(q, q);
    if (in > 0.0) rises += -4.0 * dome.height * in * (glm::transpose(dome.unit) * q);
  }
  return {rises.x, -rises.y};
}

}  // namespace mien
