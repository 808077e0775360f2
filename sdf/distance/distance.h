#pragma once
// Distances from points to curves: one at a time, or many at once.
//
//   double d = mien::distance(curve, p);                      // exact, scalar
//   mien::distances(curve, xs, ys, ds);                       // the same for spans, in SIMD
//   mien::distances(curve, xs, ys, ds, mien::Precision::accurate);
//
// Rules for every batch function
//   Spans.      x, y and d have the same length; any length and alignment will do. d may be the same span
//               as x or y (distances then replace the coordinates). Any other overlap and unequal lengths are
//               bugs that assertions catch. Without assertions the shortest length counts, and distances
//               written into an overlap are unspecified.
//   Units.      Distances have the units of the coordinates. No scale is special: everything is scaled by
//               a power of two first.
//   Totality.   Coincident and collinear control points are handled. A point or curve with a NaN or infinite
//               coordinate gives +infinity, and so does a distance beyond the type's range. Nothing hangs: no
//               loop's length depends on the numbers.
//   Same bits.  A point's result depends on that point and the curve alone. It depends neither on the
//               place in the span nor on the instruction set, among those with fused multiply-add (x86 since
//               2013, every 64-bit ARM). Machines without it keep the same error bounds.
//   Threads.    Re-entrant; no state is kept.
//
// Sources. Derived in docs/derivations and measured by the command mien-accuracy. The contracts below hold
// the bounds, and the tests read them from there.

#include <mien/api.h>
#include <mien/cubic_bezier_distance.h>
#include <mien/cubic_roots.h>
#include <mien/ellipse_distance.h>
#include <mien/parabola_side.h>
#include <mien/quad_bezier.h>
#include <mien/quad_bezier_distance.h>
#include <mien/tapered_stroke.h>

#include <span>

namespace mien {

/// The precision of float batches.
enum class Precision {
  fast,     ///< as good as float arithmetic on the curve allows
  accurate  ///< almost as if computed in double precision and rounded once
};

/// d[i] = the distance from (x[i], y[i]) to the curve. Error: DistancesContract.
MIEN_API void distances(const QuadBezier& curve, std::span<const float> x, std::span<const float> y,
                        std::span<float> d, Precision precision = Precision::fast);
MIEN_API void distances(const QuadBezier& curve, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);

/// d[i] = the distance from (x[i], y[i]) to the nearest of the curves; +infinity if there are none.
/// The error is that of a single curve of the largest one's size.
MIEN_API void distances(std::span<const QuadBezier> curves, std::span<const float> x,
                        std::span<const float> y, std::span<float> d);

/// d[j · columns + i] = the distance from (float(origin.x + i·step), float(origin.y + j·step)) to the
/// curve. If d does not have columns · rows numbers, it is left alone. This is for grids that are fine
/// compared with the curve. If all nearest points of a tile of 16 × 16 points are proven to lie on one
/// segment of the curve, each is found by Newton's method from that of the tile's centre, three times faster.
/// Other tiles are ordinary batches. The error is that of Precision::fast; the last digit may depend on where
/// the tile begins.
MIEN_API void distances_on_grid(const QuadBezier& curve, glm::dvec2 origin, double step,
                                std::size_t columns, std::size_t rows, std::span<float> d);

/// d[i] = the signed distance from (x[i], y[i]) to the figure's outline, negative inside; for a cubic
/// Bézier the unsigned distance to the curve. All are SIMD kernels. Figures and points outside a kernel's
/// contract go through the scalar function. The double versions keep the contracts of the scalar functions.
MIEN_API void distances(const Ellipse& ellipse, std::span<const float> x, std::span<const float> y,
                        std::span<float> d);
MIEN_API void distances(const Ellipse& ellipse, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);
MIEN_API void distances(const ParabolaSide& side, std::span<const float> x,
                        std::span<const float> y, std::span<float> d);
MIEN_API void distances(const ParabolaSide& side, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);
MIEN_API void distances(const TaperedStroke& stroke, std::span<const float> x,
                        std::span<const float> y, std::span<float> d);
MIEN_API void distances(const TaperedStroke& stroke, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);
MIEN_API void distances(const CubicBezier& curve, std::span<const float> x,
                        std::span<const float> y, std::span<float> d);
MIEN_API void distances(const CubicBezier& curve, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);

/// out[i] = solve_cubic(a[i], b[i], c[i], d[i]). All spans have the same length.
MIEN_API void solve_cubics(std::span<const double> a, std::span<const double> b,
                           std::span<const double> c, std::span<const double> d,
                           std::span<Roots> out);

/// The error bounds of the batch functions for quadratic Béziers. "size" is the larger side of the control
/// points' bounding box, "ulp" is the spacing of floats at the true distance, and S is the largest distance
/// from the point to a control point.
struct DistancesContract {
  static constexpr double kFastError = 4.0;      ///< × max(2⁻²³ size, ulp)
  static constexpr double kAccurateUlps = 0.86;  ///< ulps, where the distance is well-conditioned
  static constexpr double kAccurateSize = 1e-8;  ///< × size, elsewhere
  static constexpr double kDoubleError = 4.0 * 0x1p-52;  ///< × S
};

/// The error bound of the float batch for ellipses, in units of max(2⁻²³ × the larger radius, ulp). It holds
/// for radii in a ratio of at least 1e-3; thinner ellipses go through the scalar function.
struct EllipseBatchContract {
  static constexpr double kError = 4.0;
};

/// The same for strokes of varying width, in units of max(2⁻²³ × (spine's size + widest half-width), ulp).
/// Nearly straight spines, and widths that bend as much as the spine, go through the scalar function.
struct TaperedBatchContract {
  static constexpr double kError = 4.0;
};

/// The same for cubic Béziers, in units of max(2⁻²³ × size, ulp). Points whose nearest segment is not proven
/// in SIMD go through the scalar function. The double batch keeps CubicBezierContract.
struct CubicBatchContract {
  static constexpr double kError = 2.0;
};

/// The same for parabola sides, in units of max(2⁻²³ × (|foot − vertex| + |p − vertex|), ulp).
struct ParabolaBatchContract {
  static constexpr double kError = 4.0;
};

}  // namespace mien
