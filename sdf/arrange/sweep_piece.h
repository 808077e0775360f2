#pragma once
// A piece of outline while the sweep passes it, and its place at a height.
//
// A piece is (x, y)(t) = (x0, y0) + t (2a + t b), a and a + b pointing down. The height y is met at
//
//     t = d / (a.y + sqrt(a.y² + b.y d)),   d = y − y0,
//
// the root of b.y t² + 2 a.y t − d = 0 without cancellation: both terms of the divisor are >= 0.
// Its error in t is some roundings relative to t, so x is right to about 1e-15 of the piece's size.

#include "sdf/outline/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

struct SweepPiece : OutlinePiece {
  int outline, turn;               ///< of its chain
  float lowest_x, highest_x;       ///< rounded outwards
  double lean;                     ///< of its chord, dx / dy
  double left_bulge, right_bulge;  ///< how far it leaves its chord along x [px], upper bounds
  /// Two lines through its ends. No part of it lies left of the low one or right of the high one: tangents on the
  /// side to which it bends, else its chord. NaN: there is none.
  double low_top, low_bottom, high_top, high_bottom;
  int slot = -1;  ///< its place in the order from left to right; −1: not met or passed
  int left_look = 0, right_look = 0;
  int winding = 0;        ///< of its outline, to the left
  bool flips = false;     ///< whether its outline's inside changes across it
  double shown_from = 0;  ///< from what height the looks are as they are
};

inline double parameter_at(const OutlinePiece& p, double y) {
  const double d = y - p.y0, divisor = p.ay + std::sqrt(std::max(0.0, p.ay * p.ay + p.by * d));
  return std::min(std::max(0.0, d / divisor),
                  1.0);  // 0 / 0, at a level start, becomes 0
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

/// The same with the sweep at (x, y): a level piece is met at x.
inline double x_there(const OutlinePiece& p, double y, double x) {
  return p.y0 == p.y1 ? std::clamp(x, p.x0, p.x1) : x_at(p, y);
}

/// Whether the sweep, tilted a little, meets (x, y) before (u, v).
inline bool before(double x, double y, double u, double v) {
  return y != v ? y < v : x < u;
}

/// > 0 where x(e) − x(f) grows at that height.
inline double parting(const OutlinePiece& e, const OutlinePiece& f, double y) {
  const double t = parameter_at(e, y), u = parameter_at(f, y);
  return (e.ax + t * e.bx) * (f.ay + u * f.by) - (f.ax + u * f.bx) * (e.ay + t * e.by);
}

/// Twice the curvature's sign along y: x(y) is convex where this is < 0.
inline double turning(const OutlinePiece& p) {
  return p.ax * p.by - p.ay * p.bx;
}

/// The chord's x at a height.
inline double chord_at(const SweepPiece& p, double y) {
  return p.x0 + (y - p.y0) * p.lean;
}

/// A lower bound of the gap from `left` to `right` between two heights, by their chords; a poor one for level
/// pieces.
inline double chord_gap(const SweepPiece& left, const SweepPiece& right, double from, double to) {
  const double a = chord_at(right, from) - chord_at(left, from),
               b = chord_at(right, to) - chord_at(left, to);
  return std::min(a, b) - left.right_bulge - right.left_bulge;
}

/// The same by the lines through their ends: the gap between two lines is least at an end. −∞ where there are none.
inline double tangent_gap(const SweepPiece& left, const SweepPiece& right, double from, double to) {
  using Places = std::array<double, 2>;
  const auto low = [&](double y) {
    return Places{right.x0 + (y - right.y0) * right.low_top,
                  right.x1 + (y - right.y1) * right.low_bottom};
  };
  const auto high = [&](double y) {
    return Places{left.x0 + (y - left.y0) * left.high_top,
                  left.x1 + (y - left.y1) * left.high_bottom};
  };
  const Places r0 = low(from), r1 = low(to), l0 = high(from), l1 = high(to);
  double most = -HUGE_VAL;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)  // a NaN is never more
      most = std::max(most, std::min(r0[i] - l0[j], r1[i] - l1[j]));
  return most;
}

/// Whether both run the same way from end to end: pieces of abutting shapes do, or of copies of a shape, of which
/// there may be thousands.
inline bool coincide(const OutlinePiece& a, const OutlinePiece& b) {
  return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1 && a.ax == b.ax &&
         a.ay == b.ay && a.bx == b.bx && a.by == b.by;
}

SweepPiece sweep_piece(const OutlinePiece& piece, int outline = 0, int turn = 1);

}  // namespace mien
