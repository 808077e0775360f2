#pragma once
// What a shape's outline is inside a small disc: a few edges, each a straight line with a known
// bend, and a rule that says which of their sides are the shape's inside.
//
// This is the second question a shape answers to the renderer (the first is its distance). Lengths
// are in the units the shape is in; the renderer asks in pixels.

#include <mien/sdf/shape/shape.h>

#include <limits>
#include <vector>

namespace mien {

/// One smooth piece of outline near a centre c. A point c + u is inside when
///
///     d + dot(u, normal) + bend/2 · dot(u, along)² <= 0,      along = (−normal.y, normal.x),
///
/// the outline's expansion to second order about the foot of c.
struct Edge {
  double d;  ///< signed distance from c to the outline's tangent at the foot; negative: c is inside
  glm::dvec2 normal;  ///< unit, outward
  double bend;        ///< curvature of the outline; positive where the inside is convex
  int turn = 1;       ///< winding rules: what the winding number loses on leaving across the edge
};

enum class EdgeRule : unsigned char {
  outside,  ///< the whole disc is outside: no edges
  inside,   ///< the whole disc is inside: no edges
  all,      ///< inside every edge
  any,      ///< inside at least one
  nonzero,  ///< winding + sum of the turns of the edges it is inside of is not 0
  even_odd  ///< … is odd
};

/// The edges of one shape near c, as a range of a list.
struct LocalOutline {
  EdgeRule rule = EdgeRule::outside;
  int first = 0, count = 0;  ///< in the list given to edges_near
  int winding = 0;           ///< outside of all the edges
  /// The outline within the disc deviates from this description by at most this much, bends
  /// included. Infinity: nothing is proven (a corner, an end, two branches); still the best
  /// description known.
  double error = 0;
  /// The same if the edges are taken as circles instead: d and the bend as a radius.
  double round_error = 0;
};

inline constexpr double kUnproven = std::numeric_limits<double>::infinity();

/// A shape grown by `offset` (shrunk if negative): the points with distance <= offset.
struct OffsetShape {
  Shape shape;
  double offset = 0;
};

inline double distance(const OffsetShape& s, glm::dvec2 p) {
  return distance(s.shape, p) - s.offset;
}

/// Describes the outline within the disc (c, radius), appending to `edges`.
LocalOutline edges_near(const OffsetShape& shape, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges);

}  // namespace mien
