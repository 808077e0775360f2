#pragma once
// A quadratic curve with a half-width along it: the disc (B(t), w(t)) for every t from 0 to 1.
//
// Strokes are unions of those discs: their distance is the least |p − B(t)| − w(t). Sides of paths are spines without
// width, with an outside.

#include <glm/vec2.hpp>

namespace mien {

/// x = x0 + t (x1 + t x2), likewise y and the half-width w.
struct Spine {
  double x0, x1, x2, y0, y1, y2, w0, w1, w2;
  /// Of a path: outward, unit, between this side's normal and the next's.
  double begin_x, begin_y, end_x, end_y;
  /// Of a path: outward is side · (y', −x'). Of strokes: 0.
  double side;
};

inline glm::dvec2 on_spine(const Spine& s, double t) {
  return {s.x0 + t * (s.x1 + t * s.x2), s.y0 + t * (s.y1 + t * s.y2)};
}
/// B'.
inline glm::dvec2 along_spine(const Spine& s, double t) {
  return {s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2};
}
inline double width_on_spine(const Spine& s, double t) {
  return s.w0 + t * (s.w1 + t * s.w2);
}

}  // namespace mien
