#pragma once
// A cubic Bézier made ready for many points: cut into kPieces pieces, each with bounds of the slope
// of the squared distance on it (docs/derivations/cubic_bezier.md).
//
// All lengths are first multiplied by `scale`, a power of two that brings the curve's largest leg to
// about 1. With o = p0 − p and u = B'/3 the slope of |B − p|²/2 is 3f, f = (B − p)·u.

#include <mien/cubic_bezier.h>

#include <array>
#include <optional>

namespace mien::batch {

/// B(t) − p0 = m + τ (a + τ (b + τ c)) with τ = t − ½: constants about the middle, so that none is larger than the
/// curve.
template <class T>
struct CubicExpansion {
  T mx, my, ax, ay, bx, by, cx, cy;
  T ux, uy, vx, vy, c2x,
      c2y;         ///< u = B'/3 = (a/3) + τ (v + τ c), u' = v + τ 2c: ux = a/3, v = 2b/3
  T end_x, end_y;  ///< p3 − p0
};

template <class T>
struct CubicFrame {
  static constexpr int kPieces = 16;  ///< a power of two: every border and middle is exact

  T scale, unscale;  ///< powers of two; unscale = 1 / scale
  T x0, y0;          ///< p0 · scale
  T x0_low, y0_low;  ///< what rounding p0 · scale to T left over
  CubicExpansion<T> curve;
  CubicExpansion<double> fine;
  struct Sample {
    T x, y, ux, uy;  ///< B − p0 and u at a border or a middle, alternately: t = i / 2 kPieces
  };
  std::array<Sample, 2 * kPieces + 1> sample;
  struct Piece {
    T reach, reach2;  ///< every point is within reach / 2 of one of the three samples; (reach / 2)²
    /// f on the piece is within `off` of the parabola through its three samples. The difference of f' and the
    /// parabola's slope does not depend on the point. Times the piece's width it is within `tilt` of `turn` at the
    /// ends, of −turn/2 in the middle, and of the parabola through these between them.
    T off, turn, tilt;
  };
  std::array<Piece, kPieces> piece;
  /// |f''| <= curl + U curl_far, U the distance of the nearest sample, on the pieces that may have the
  /// nearest point, up to 1/64 beyond the ends too.
  T curl, curl_far;
};

/// None for a curve that is a point, not finite or out of float's range.
template <class T>
std::optional<CubicFrame<T>> cubic_frame(const CubicBezier& curve);

}  // namespace mien::batch
