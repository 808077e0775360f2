#pragma once
// What a distance looks like in a small square, from nine places of it.

#include <array>
#include <glm/vec2.hpp>

namespace mien {

/// A distance at (−h, 0, h)², row by row from the top.
using NineDistances = std::array<double, 9>;

/// The distance as  at + dot(normal, p) + bend/2 · dot(along, p)²,  p from the square's middle: the
/// form of every distance to a smooth outline, up to terms of third order.
struct OutlineFit {
  double at = 0;
  glm::dvec2 normal{1.0, 0.0};  ///< unit
  double bend = 0;              ///< [1/px]
  double off = 0;               ///< the most that one of the nine places leaves the form by

  glm::dvec2 along() const { return {-normal.y, normal.x}; }
};

/// The nearest such form; off is large where the distance has a kink.
OutlineFit fit_outline(const NineDistances& d, double half);

/// What nine distances to a smooth outline may leave their form by: terms of third order. More is a kink,
/// or another outline near the border.
double allowed_off(const OutlineFit& fit, double half, double tolerance);

/// A part of a straight line, from `from` to `to` along `along`, at `offset` + dot(normal, p) = 0.
struct Chord {
  double from = 0, to = 0;
  double length() const { return to - from; }
};

/// What the square holds of a straight line; no length where the line passes it by.
Chord chord_in_square(glm::dvec2 normal, double offset, double half);

}  // namespace mien
