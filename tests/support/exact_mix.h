#pragma once
// A colour mixed in both blending spaces at once: their areas are the same, only colours differ.

#include <mien/view.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace mien::test {

inline double encoded(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

inline double decoded(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Premultiplied: in linear light, and in encoded values.
struct Mixes {
  glm::dvec4 linear{0.0}, srgb{0.0};

  const glm::dvec4& in(Blend blend) const { return blend == Blend::linear ? linear : srgb; }
};

inline Mixes operator+(const Mixes& a, const Mixes& b) {
  return {a.linear + b.linear, a.srgb + b.srgb};
}
inline Mixes operator-(const Mixes& a, const Mixes& b) {
  return {a.linear - b.linear, a.srgb - b.srgb};
}
inline Mixes operator*(double s, const Mixes& a) {
  return {s * a.linear, s * a.srgb};
}

inline Mixes laid_over(const Mixes& top, const Mixes& below) {
  return {top.linear + (1 - top.linear.a) * below.linear, top.srgb + (1 - top.srgb.a) * below.srgb};
}

inline double largest(const glm::dvec4& v) {
  return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b), std::abs(v.a)});
}

}  // namespace mien::test
