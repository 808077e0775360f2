#pragma once
// How far squares of a leaf may be off, in areas of pixels, when their edges are taken for simpler ones than
// they are. Both forms, scalar and in vectors, divide squares where these exceed what is allowed.

#include <mien/sdf/edge/leaf_edge.h>

namespace mien {

/// A straightened edge covers what the bent one covers as long as it is alone; its error is where
/// another edge cuts the same square. There it is at most bend L³ · 0.064 of area (|t²/2 − mean| over a
/// chord of length L <= 1.41 sides), and two edges that cross do so in one square or two.
inline constexpr double kTogether = 0.36;
template <class T>
constexpr T together_error(T bends, T side) {
  return T(kTogether) * bends * side * side * side;
}

/// A circle leaves its parabola by bend³ t⁴ / 8, which over the longest chord through a square of side s,
/// |t| <= 0.71 s, is an area of 0.0089 bend³ s⁵ (while small); an outline through a pixel crosses about 2/s such squares.
/// (Without this a cap of radius 1.03 px was off by 0.0074 of a pixel, almost two levels.)
inline constexpr double kParabola = 0.018;
template <class T>
constexpr T parabola_error(T bend, T side) {
  const T b = (bend < 0 ? -bend : bend) * side;
  return T(kParabola) * b * b * b * side;
}

/// A square with a round end's beginning in it, taken for all circle or all body: bend side² / 8 over a
/// part of it.
template <class T>
constexpr T end_error(T end_bend, T side) {
  return T(0.0625) * side * side * side * end_bend;
}

/// The other body leaves the one taken for the whole square by bend x²/2 and turn x at x beyond the
/// joint, 0.71 sides at most: of area, bend side² 0.06 and turn side² / 4 of a pixel.
template <class T>
constexpr T joint_error(T bend_change, T side) {
  const T b = bend_change < 0 ? -bend_change : bend_change;
  return side * side * (T(0.06) * side * b + T(0.25 * kMostJointTurn));
}

}  // namespace mien
