#pragma once
// A colour mixed in both blending spaces at once: their areas are the same, only colours differ.

#include <mien/mix_mode.h>
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

/// A group's colour mixed with what is below: the W3C's formulas of compositing and blending, word for word, of straight
/// colours.
inline glm::dvec4 mixed_by(MixMode mode, const glm::dvec4& group, const glm::dvec4& below) {
  const double as = group.a, ab = below.a;
  glm::dvec4 out{0, 0, 0, as + ab * (1 - as)};
  for (int i = 0; i < 3; ++i) {
    const double cb = ab > 0 ? below[i] / ab : 0;
    double cs = as > 0 ? group[i] / as : 0;
    const double both = mode == MixMode::multiply ? cb * cs
                        : mode == MixMode::screen ? 1 - (1 - cb) * (1 - cs)
                                                  : cs;
    cs = (1 - ab) * cs + ab * both;
    out[i] = as * cs + ab * cb * (1 - as);
  }
  return out;
}

inline Mixes mixed_by(MixMode mode, const Mixes& group, const Mixes& below) {
  return {mixed_by(mode, group.linear, below.linear), mixed_by(mode, group.srgb, below.srgb)};
}

inline double largest(const glm::dvec4& v) {
  return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b), std::abs(v.a)});
}

}  // namespace mien::test
