#pragma once
// Colours by perceived lightness, chroma and hue.
//
// Source. Björn Ottosson, "A perceptual color space for image processing" (2020): OKLab and its polar form.

#include <glm/vec3.hpp>
#include <string>

namespace mien {

/// Lightness 0 … 1, chroma 0 … 0.37 or so, hue in degrees.
struct Oklch {
  double lightness = 0, chroma = 0, hue = 0;

  /// L, a, b.
  glm::dvec3 lab() const;
  static Oklch from_lab(glm::dvec3 lab);
  /// Of linear red, green, blue.
  static Oklch from_linear(glm::dvec3 linear);
};

/// The perceived difference of two colours; 0.02 is just noticeable.
double apart(const Oklch& a, const Oklch& b);

/// "#rrggbbaa", the same on every machine, or without the alpha where it is 1. Chroma is lowered until the colour can be shown.
std::string hex_of(const Oklch& color, double alpha = 1);

}  // namespace mien
