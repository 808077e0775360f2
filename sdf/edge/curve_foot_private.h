#pragma once
// The foot of a point on a quadratic curve, with a proof of how far the curve's expansion there
// reaches.

#include <mien/lib/geom/quad_bezier.h>

#include <glm/vec2.hpp>

namespace mien {

/// C(t) = p0 + t (v + t w), t in [lo, hi]; the ends may be infinite.
struct QuadCurve {
  glm::dvec2 p0, v, w;
  double lo, hi;

  glm::dvec2 at(double t) const { return p0 + t * (v + t * w); }
  glm::dvec2 velocity(double t) const { return v + 2.0 * t * w; }
};

QuadCurve curve_of(const QuadBezier& bezier);

/// Where the nearest point of a curve lies and what the curve is like around it.
struct CurveFoot {
  enum class Where { body, begin, end } where;
  double t;
  glm::dvec2 point;
  glm::dvec2 tangent;  ///< unit, towards larger t
  glm::dvec2 normal;   ///< unit, left of the tangent: (−tangent.y, tangent.x)
  double distance;     ///< from c, >= 0
  double side;         ///< dot(c − point, normal): the signed distance if where is body
  double bend;         ///< curvature, positive if the curve turns towards `normal`
  double bend_change;  ///< bound on |d bend / d arc length| for every foot of the disc
  /// Every point of the disc within `level` + radius of the curve has its nearest point on this one
  /// smooth piece and of this kind (body, begin or end).
  bool proven;
  /// As proven, but the disc straddles the normal line through an end: body and cap both occur.
  bool straddles_end;
};

/// The foot of c, and the proof for the disc (c, radius) at outlines `level` >= 0 away from the curve.
///
/// Proof (docs/derivations/edges.md). With J the piece of curve around the foot within arc
/// sqrt(8·level·radius) + 4·radius, it is proven when every point of the curve outside J is farther than
/// level + radius from c, and |C − p|² is convex on J for every p of the disc, and the feet of the disc
/// lie within arc 2·radius of this one.
CurveFoot foot_near(const QuadCurve& curve, glm::dvec2 c, double radius, double level);

}  // namespace mien
