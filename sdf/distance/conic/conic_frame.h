#pragma once
// Ellipses and parabola sides made ready for many points, as QuadBezierFrame is for Bézier curves:
// lengths scaled by a power of two, constants computed in double precision and rounded once.

#include <mien/ellipse.h>
#include <mien/shape.h>

#include <optional>

namespace mien::batch {

/// In the frame whose first axis is the longer radius: that radius is `a`, in [1/2, 1).
template <class T>
struct EllipseFrame {
  T scale, unscale;        ///< powers of two
  T x0, y0, low_x, low_y;  ///< center · scale, and what its rounding left over
  T axis_x, axis_y;        ///< unit, along the longer radius
  T a, b;                  ///< radii · scale
  T focal;                 ///< a² − b²
  T guess_focal;           ///< the same, at least 1e-6 a²: for the first guess
};

/// None where the kernel promises nothing: radii not finite or out of float's range, or a ratio of the radii below
/// kThinnest.
template <class T>
std::optional<EllipseFrame<T>> ellipse_frame(const Ellipse& ellipse);
inline constexpr double kThinnest = 1e-3;

/// In units of the focal length: multiplied by the bend, every parabola is y = x².
template <class T>
struct ParabolaFrame {
  T scale, unscale;        ///< bend, 1 / bend
  T x0, y0, low_x, low_y;  ///< vertex, and what its rounding left over
  T axis_x, axis_y;        ///< unit, to the inside
  bool mirrored;           ///< bend < 0: the outside of the mirrored parabola
};

/// None for a bend of 0 and for numbers not finite or out of float's range.
template <class T>
std::optional<ParabolaFrame<T>> parabola_frame(const ParabolaSide& side);

}  // namespace mien::batch
