#pragma once
// What an outline is inside a leaf, a square of at most 16 pixels: a point of the outline, its
// normal and curvature and how the curvature changes, relative to the leaf's centre, in float, with
// a proven bound on what is left out. Pixels need nothing else: no root is solved for them.

#include <mien/sdf/edge/edge.h>

namespace mien {

/// [px] Just more than half a pixel's diagonal: a pixel that the round end crosses is one edge's
/// alone, and away from it both edges of the stroke agree.
inline constexpr float kEndHalo = 0.75f;

/// [rad] Bodies that are joined turn by at most this at the joint.
inline constexpr double kMostJointTurn = 0.005;

/// One smooth piece of outline. With u = p − (x, y), Y = dot(u, n) and X = dot(u, m),
/// m = (−n.y, n.x), a point p of the leaf is inside when
///
///     d(u) + (c3 X³ + c4 X⁴) (1 + (bend X)²/2) <= 0,
///
/// d the signed distance to the circle Y + bend/2 |u|² = 0: the osculating circle, exactly, and the
/// third and fourth order by which the outline leaves it, per arc length rather than X; c3 with the fifth
/// order folded in (leaf_remainder-inl.h).
struct LeafEdge {
  float x, y;    ///< a point of the outline
  float nx, ny;  ///< unit outward normal there
  float bend;    ///< curvature; positive where the inside is convex
  float c3, c4;
  int turn;  ///< winding rules: see Edge

  /// A round end. Where dot(p − end, along) > 0 the outline is the circle of curvature `end_bend`
  /// around `end` instead, as far as it lies on the side dot(p − end, normal at the end) > 0; on
  /// the other side the point counts as inside (the stroke's other edge decides there) unless it is
  /// more than kEndHalo outside the circle and beyond the other edge's line too.
  float end_x, end_y, along_x, along_y;  ///< along: unit, out of the body; (0, 0): no end
  float other_x, other_y;                ///< along, of the stroke's other edge
  float end_bend, end_nx, end_ny;        ///< the normal at the end, towards this edge's side
  float error;                           ///< [px] the outline deviates by at most this in the leaf

  /// A joint: where dot(p − end, along) > 0 this body is the outline instead, which continues the
  /// first smoothly at `end`.
  struct Body {
    float x, y, nx, ny, bend, c3, c4;
  };
  Body next{};
  bool joined = false;

  bool has_end() const { return end_bend != 0; }

  /// The edge whose body is the joint's other one.
  LeafEdge beyond() const {
    LeafEdge e = *this;
    e.x = next.x, e.y = next.y, e.nx = next.nx, e.ny = next.ny;
    e.bend = next.bend, e.c3 = next.c3, e.c4 = next.c4;
    return e;
  }
};

/// The edges of one outline in one leaf: a range of a list.
struct LeafOutline {
  EdgeRule rule = EdgeRule::outside;
  int first = 0, count = 0;
  int winding = 0;
  double error = kUnproven;  ///< of the worst edge; kUnproven: ask for smaller leaves
};

}  // namespace mien
