#pragma once
// The outline of a parabola's side: its points, and the ones nearest to p.

#include <mien/cubic_roots.h>
#include <mien/shape.h>

#include <glm/vec2.hpp>

namespace mien {

/// The outline's point at distance u from the axis: vertex + u·(axis turned left) + bend u²·axis.
MIEN_API glm::dvec2 point(const ParabolaSide& side, double u);

struct NearestOnParabola {
  double distance;   ///< signed, negative inside: distance(side, p)
  double u;          ///< of the nearest point; on the axis inside a bend, the positive one of two
  glm::dvec2 point;  ///< the outline at u
};

/// With P = (u0, v0) in the frame of vertex and axis, the nearest point (s, k s²) has
///     f(s) = (s − u0) + 2 k s (k s² − v0) = 0,
/// a cubic with exactly one positive root for k, u0 > 0 (Descartes), which is the nearest point by
/// symmetry. Newton comes down to it from a bound above, monotonically, as f is convex there; f is
/// evaluated as written, from the residual. The distance is the residual along the normal there.
/// Error. At most 4·2⁻⁵²·(|p − foot| + the coordinates of both relative to the vertex).
/// Source. Derived here; tests/sdf/shape/curve/parabola_side_test.cpp compares with binary128.
MIEN_API NearestOnParabola nearest(const ParabolaSide& side, glm::dvec2 p);

/// Every u where p is perpendicularly off the outline, ascending.
MIEN_API Roots feet(const ParabolaSide& side, glm::dvec2 p);

struct ParabolaSideContract {
  static constexpr double kError = 4.0 * 0x1p-52;
};

}  // namespace mien
