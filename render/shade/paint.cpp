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

}  // namespace mien
