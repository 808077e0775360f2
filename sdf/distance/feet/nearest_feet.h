#pragma once
// Feet: where on a curve the nearest point lies, in which direction, and the runner-up.
//
//   mien::Feet feet = mien::nearest_feet(curves, p);                // one place
//   mien::nearest_feet(curves, xs, ys, nearest, next);              // many, in SIMD
//
// A foot is a local minimum of the distance along the curve: a place where the curve is perpendicular to the way to p,
// an end, or a corner. `nearest` is the lowest of them and `next` the runner-up, whichever piece it is on. Their
// figures say how far the ridge (medial axis) is, where the gradient jumps from one to the other: about
// (d' - d) / |n' - n| away, in the direction of n - n'.
//
//   Pieces.     Curves in a list are one piece each. A piece that begins exactly where the one before ends (with the
//               same half-width) continues it, and a chain may close: a joint is a foot only where it is one of the
//               whole chain, and belongs to the piece that begins there.
//   Parameter.  0 to 1 along Bézier curves and lines; of an ellipse the angle [rad, −π to π] of the point
//               center + radii.x cos t axis + radii.y sin t (axis turned left).
//   Distance.   As distance() has it: unsigned for QuadBezier, of a Line and a TaperedStroke |p − B(t)| − w(t), of an
//               Ellipse negative inside; there the next foot has the sign of the place, too.
//   Normal.     The gradient of that distance, of length 1. On a curve itself, where it jumps, to the right of a
//               rising t (y up); of an ellipse outward. At an end itself it points out of the curve.
//   Bend.       The curvature of the level line through p, ∇·n: positive where it bends away from the normal, 1/r for
//               the circles round an end. Infinite at a centre of curvature.
//   Absent.     piece −1, distance +infinity, all else 0: where there is no second foot, in an empty list, and for a
//               place with a NaN or infinite coordinate. A piece with one is passed over.
//   Ties.       The piece that comes first, then the smaller t. Minima less than 2⁻²⁰ of a piece apart are one, unless
//               a corner is between them.
//   Same bits.  A place's answer depends on it and the curves alone. On every machine and instruction set a batch has
//               the same bytes: nothing is fused. The scalar form keeps the same bounds, by code of its own.
//   Error.      FeetContract. Threads: re-entrant.
//
// Source: docs/derivations/feet.md, measured by mien-accuracy --feet.

#include <mien/api.h>
#include <mien/shape.h>

#include <cstdint>
#include <limits>
#include <span>

namespace mien {

struct Foot {
  std::int32_t piece = -1;
  double t = 0.0;
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec2 normal{0.0};
  double bend = 0.0;  ///< 1 / length
};

struct Feet {
  Foot nearest, next;
};

/// Where a batch writes: each span has the length of the coordinates, or is empty and left out.
struct FootSpans {
  std::span<std::int32_t> piece;
  std::span<double> t, distance, normal_x, normal_y, bend;
};

MIEN_API Feet nearest_feet(std::span<const QuadBezier> curves, glm::dvec2 p);
MIEN_API Feet nearest_feet(std::span<const Line> lines, glm::dvec2 p);
MIEN_API Feet nearest_feet(std::span<const TaperedStroke> strokes, glm::dvec2 p);
MIEN_API Feet nearest_feet(const Ellipse& ellipse, glm::dvec2 p);

/// The same from (x[i], y[i]). Results may not overlap the coordinates or each other. Unequal lengths are bugs that
/// assertions catch; without them the shortest counts.
MIEN_API void nearest_feet(std::span<const QuadBezier> curves, std::span<const double> x,
                           std::span<const double> y, const FootSpans& nearest,
                           const FootSpans& next);
MIEN_API void nearest_feet(std::span<const Line> lines, std::span<const double> x,
                           std::span<const double> y, const FootSpans& nearest,
                           const FootSpans& next);
MIEN_API void nearest_feet(std::span<const TaperedStroke> strokes, std::span<const double> x,
                           std::span<const double> y, const FootSpans& nearest,
                           const FootSpans& next);
MIEN_API void nearest_feet(const Ellipse& ellipse, std::span<const double> x,
                           std::span<const double> y, const FootSpans& nearest,
                           const FootSpans& next);

/// Errors, in units of 2⁻⁵² S; S is the largest distance from p to a control point (or to the centre, with the larger
/// radius), with the widest half-width.
struct FeetContract {
  static constexpr double kDistance = 8.0;
  /// Times |bend| + 1 / max(|p − B|, √(B'² − w'²)), [1 / length]: what moving the place and the curve as far does.
  static constexpr double kNormal = 32.0;
};

}  // namespace mien
