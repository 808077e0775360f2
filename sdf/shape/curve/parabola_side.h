#pragma once
// The outline of a parabola's side: its points, and the nearest of them to p.

#include <mien/cubic_roots.h>
#include <mien/shape.h>

#include <glm/vec2.hpp>

namespace mien {

/// The outline's point at distance u from the axis: vertex + u·(axis turned left) + bend u²·axis.
MIEN_API glm::dvec2 point(const ParabolaSide& side, double u);

struct NearestOnParabola {
  double distance;   ///< signed, negative inside: distance(side, p)
  double u;          ///< of the nearest point; the positive one where two are equally near
  glm::dvec2 point;  ///< the outline at u
};

/// With P = (u0, v0) in the frame of vertex and axis, the nearest point (s, k s²) has
///     f(s) = (s − u0) + 2 k s (k s² − v0) = 0,
/// a cubic. For k, u0 > 0 it has exactly one positive root (Descartes), which by symmetry is the nearest
/// point. f is convex there, so Newton's method descends to the root monotonically from an upper bound.
/// f is evaluated as written, from the residual. The distance is the residual along the normal.
/// Error. At most 4·2⁻⁵²·(|p − foot| + the coordinates of both relative to the vertex).
/// Source. Derived here; tests/sdf/shape/curve/parabola_side_test.cpp compares with binary128.
MIEN_API NearestOnParabola nearest(const ParabolaSide& side, glm::dvec2 p);

/// Every u at which the outline's normal passes through p, ascending.
MIEN_API Roots feet(const ParabolaSide& side, glm::dvec2 p);

struct ParabolaSideContract {
  static constexpr double kError = 4.0 * 0x1p-52;
};

}  // namespace mien
