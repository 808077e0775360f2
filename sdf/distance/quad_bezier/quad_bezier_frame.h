#pragma once
// A quadratic Bézier made ready for many points: everything that depends on the curve alone,
// computed once in double precision and rounded once to the type of the lanes.
//
// All lengths are first multiplied by `scale`, a power of two that brings the curve's larger leg to
// about 1: kernels never meet an overflow they did not ask for, and the scaling is exact.
//
// The parabola's own frame, without ever rotating into it (docs/derivations/quad_bezier.md): with
// d = p0 − p, a = p1 − p0, b = p0 − 2 p1 + p2, the critical points of |B(t) − p|² are t = x −
// vertex, where x solves x³ + 3 P x − S2 = 0, and P and S2 are affine in d.

#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace mien::batch {

template <class T>
struct QuadBezierFrame {
  T scale, unscale;    ///< powers of two; unscale = 1 / scale
  T x0, y0;            ///< p0 · scale
  T x0_low, y0_low;    ///< what rounding p0 · scale to T left over
  T ax2, ay2, bx, by;  ///< B(t) − p = d + t (2a + t b)
  T bx2, by2;          ///< 2b
  T px, py, p1;        ///< P = px·dx + py·dy + p1
  T sx, sy, s1;        ///< S2 = sx·dx + sy·dy + s1
  T vertex;            ///< −t at the parabola's vertex: a·b / b·b
  T chord_x, chord_y;  ///< (p2 − p0) / |p2 − p0|²; zero if the ends coincide
  bool has_low;        ///< x0_low or y0_low is not zero
  bool straight;       ///< |b| <= kStraight · larger leg: start from the chord
};

/// Up to this ratio of |b| to the larger leg the curve is treated as nearly straight. Just above it
/// the cubic's root loses log2(1/ratio) bits to x − vertex, which one step on the curve restores.
/// Just below it the evolute is 1/(4 ratio) legs away, where two minima differ by less than the
/// distance's rounding.
template <class T>
inline constexpr double kStraight = sizeof(T) == 4 ? 0x1p-6 : 0x1p-12;

/// The exponent e such that 2^e times the larger leg's larger coordinate is in [1/2, 1), clamped so
/// that 2^e and 2^−e are normal floats. Frames have one for every curve with finite control points
/// that are not all equal and within the range of float; the others have none.
std::optional<int> scale_exponent(const QuadBezier& curve);

/// The curve times 2^exponent, ready for lanes of T.
template <class T>
QuadBezierFrame<T> quad_bezier_frame(const QuadBezier& curve, int exponent);

/// The least scalar distance to any of the curves; +infinity if there are none.
double distance_to_nearest(std::span<const QuadBezier> curves, glm::dvec2 p);

}  // namespace mien::batch
