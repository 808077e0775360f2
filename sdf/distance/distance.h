#pragma once
// How far points are from curves: one at a time, or many at once.
//
//   double d = mien::distance(curve, p);                      // exact, scalar
//   mien::distances(curve, xs, ys, ds);                       // the same for spans, 16 lanes at a time
//   mien::distances(curve, xs, ys, ds, mien::Precision::accurate);
//
// Rules for every batch function
//   Spans.      x, y and d have the same length, any length, any alignment. d may be the very span x or y
//               (the distances replace the coordinates). Any other overlap, and unequal lengths, are mistakes
//               that assertions catch; without them the shortest length counts, and distances into an
//               overlap are unspecified.
//   Units.      Distances come out in the units of the coordinates. No scale is special: everything is
//               scaled by a power of two first.
//   Totality.   Coincident and collinear control points are right. A point or curve with a NaN or infinite
//               coordinate gives +infinity. A distance beyond the type's range is +infinity. Nothing hangs:
//               there is no loop whose length depends on the numbers.
//   Same bits.  A point's result depends on that point and the curve alone: not on its place in the span
//               nor on the instruction set, among those with fused multiply-add (x86 since 2013, every
//               64-bit ARM). Machines without it keep the same error bounds.
//   Threads.    Re-entrant; no state is kept.
//
// Sources. Derived in docs/derivations; measured by the command mien-accuracy; bounds in the contracts
// below, which the tests read.

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

/// How float batches round.
enum class Precision {
  fast,     ///< as good as float arithmetic on the curve gets
  accurate  ///< as if computed in double precision and rounded, almost
};

/// d[i] = the distance from (x[i], y[i]) to the curve. Error: DistancesContract.
MIEN_API void distances(const QuadBezier& curve, std::span<const float> x, std::span<const float> y,
                        std::span<float> d, Precision precision = Precision::fast);
MIEN_API void distances(const QuadBezier& curve, std::span<const double> x,
                        std::span<const double> y, std::span<double> d);

/// d[i] = the distance from (x[i], y[i]) to the nearest of the curves; +infinity if there are none.
/// The error is that of one curve, with the size of the largest.
MIEN_API void distances(std::span<const QuadBezier> curves, std::span<const float> x,
                        std::span<const float> y, std::span<float> d);

/// d[j · columns + i] = the distance from (float(origin.x + i·step), float(origin.y + j·step)) to the
/// curve; d has columns · rows numbers, or it is left alone. For grids that are fine beside the curve: where
/// the nearest points of a whole tile of 16 × 16 points are proven to lie on one piece of curve, each is
/// found by Newton's method from that of the tile's middle, at a third of the price; tiles without proof
/// are batches like any other. The
/// error is that of Precision::fast; the last digit may depend on where the tile begins.
MIEN_API void distances_on_grid(const QuadBezier& curve, glm::dvec2 origin, double step,
                                std::size_t columns, std::size_t rows, std::span<float> d);

/// d[i] = the signed distance from (x[i], y[i]) to the figure's outline, negative inside (to a cubic
/// Bézier: the distance). Every form is a kernel; figures and points that it does not promise for go
/// through the scalar form. The double forms keep the scalar forms' contracts.
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

/// out[i] = solve_cubic(a[i], b[i], c[i], d[i]); all spans of the same length.
MIEN_API void solve_cubics(std::span<const double> a, std::span<const double> b,
                           std::span<const double> c, std::span<const double> d,
                           std::span<Roots> out);

/// What the batch functions for quadratic Béziers promise. "size" is the larger side of the control
/// points' bounding box, "ulp" the spacing of floats at the true distance, S the largest distance
/// from the point to a control point.
struct DistancesContract {
  static constexpr double kFastError = 4.0;      ///< × max(2⁻²³ size, ulp)
  static constexpr double kAccurateUlps = 0.86;  ///< ulps, where the distance is well-conditioned
  static constexpr double kAccurateSize = 1e-8;  ///< × size, elsewhere
  static constexpr double kDoubleError = 4.0 * 0x1p-52;  ///< × S
};

/// What the float batch of ellipses promises: for a ratio of the radii of at least 1e-3 (thinner
/// ones go through the scalar form), in units of max(2⁻²³ × the larger radius, ulp).
struct EllipseBatchContract {
  static constexpr double kError = 4.0;
};

/// And of strokes of varying width: in units of max(2⁻²³ × (spine's size + widest half-width), ulp).
/// Nearly straight spines, and widths that bend as much as the spine, go through the scalar form.
struct TaperedBatchContract {
  static constexpr double kError = 4.0;
};

/// And of cubic Béziers: in units of max(2⁻²³ × size, ulp). Points whose nearest piece of curve is not
/// proven in lanes go through the scalar form. Their double batch keeps CubicBezierContract.
struct CubicBatchContract {
  static constexpr double kError = 2.0;
};

/// And of parabola sides: in units of max(2⁻²³ × (|foot − vertex| + |p − vertex|), ulp).
struct ParabolaBatchContract {
  static constexpr double kError = 4.0;
};

}  // namespace mien
