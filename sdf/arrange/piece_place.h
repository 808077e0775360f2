#pragma once
// The place of a piece at a height.
//
// A piece is (x, y)(t) = (x0, y0) + t (2a + t b), a and a + b pointing down. The height y is met at
//
//     t = d / (a.y + sqrt(a.y² + b.y d)),   d = y − y0,
//
// the root of b.y t² + 2 a.y t − d = 0 without cancellation: both terms of the divisor are >= 0.
// Its error in t is some roundings relative to t, so x is right to about 1e-15 of the piece's size.

#include "sdf/outline/outlines.h"

#include <algorithm>
#include <cmath>

namespace mien {

inline double parameter_at(const OutlinePiece& p, double y) {
  const double d = y - p.y0, divisor = p.ay + std::sqrt(std::max(0.0, p.ay * p.ay + p.by * d));
  return divisor > 0.0 ? std::min(std::max(0.0, d / divisor), 1.0) : 0.0;
}

inline double x_of(const OutlinePiece& p, double t) {
  return p.x0 + t * (2.0 * p.ax + t * p.bx);
}

/// Its x at a height, clamped to its ends.
inline double x_at(const OutlinePiece& p, double y) {
  if (y >= p.y1) return p.x1;
  if (y <= p.y0) return p.x0;
  const double x = x_of(p, parameter_at(p, y));
  return p.x1 > p.x0 ? std::clamp(x, p.x0, p.x1) : std::clamp(x, p.x1, p.x0);
}

/// Twice the curvature's sign along y: x(y) is convex where this is < 0.
inline double turning(const OutlinePiece& p) {
  return p.ax * p.by - p.ay * p.bx;
}

/// Two pieces at a height: parameters and places.
struct PairLevel {
  double y, l, r, left_x, right_x;
  double gap() const { return right_x - left_x; }
};

inline PairLevel pair_at(const OutlinePiece& left, const OutlinePiece& right, double y) {
  const double l = parameter_at(left, y), r = parameter_at(right, y);
  return {y, l, r, x_of(left, l), x_of(right, r)};
}

/// > 0 where the gap from `left` to `right` grows downwards.
inline double widening(const OutlinePiece& left, const OutlinePiece& right, const PairLevel& at) {
  return (right.ax + at.r * right.bx) * (left.ay + at.l * left.by) -
         (left.ax + at.l * left.bx) * (right.ay + at.r * right.by);
}

}  // namespace mien
