#pragma once
// An outline along a parabola or an ellipse, made ready for leaf_edges: what depends on the shape
// alone.

#include <mien/sdf/edge/edge.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

namespace mien {

/// The outline at `level` from a piece of the parabola y = a x², x in [lo, hi], in the right-handed
/// frame (origin, right, up). A stroke's outlines are both levels ±level; a side's is one.
struct ParabolaForm {
  glm::dvec2 origin;
  glm::dvec2 right;  ///< unit; up = (−right.y, right.x)
  double a;
  double lo, hi;  ///< infinite: no ends
  double level;   ///< stroke: half-width > 0. Side: the outline runs `level` above the parabola
  bool stroke;
  /// Points closer than this to the piece, made longer by kMargin at its ends, have one nearest
  /// point on it, and every critical point that close is it.
  double reach;

  /// Whether the piece lies on one flank, far from the vertex.
  bool steep() const {
    constexpr double kSteep = 0.5;
    return a * lo * (a * hi) > 0.0 && std::min(std::abs(2 * a * lo), std::abs(2 * a * hi)) > kSteep;
  }

  static constexpr double kMargin = 32;  ///< [px]
};

/// The parabola that a quadratic curve lies on: its piece, with level 0 and no stroke.
struct ParabolaPiece {
  ParabolaForm form;  ///< but for its reach
  bool forwards;      ///< the curve runs towards the frame's +x
};
/// Nothing for a curve without length, one that doubles back on a straight line, or one so far from
/// its parabola's vertex that the frame loses digits which the curve still has.
std::optional<ParabolaPiece> parabola_piece(const QuadBezier& curve);

/// The reach of the piece, made longer by arc `margin` at both ends, or a bound below it.
double reach_of(const ParabolaForm& form, double margin);

/// Whether points of a disc whose outlines are at most `level` from a curve of that reach have their feet
/// within arc 2·radius of the centre's. On the way to a point at distance `level`, with τ to go, the foot moves at most
/// reach/(reach − level − τ) times as fast (Federer); summed: reach ln((reach − level)/(reach − level − radius)).
inline bool feet_are_near(double reach, double level, double radius) {
  const double far = level + radius;
  if (2.0 * far <= reach) return true;
  return far < reach && reach * std::log((reach - level) / (reach - far)) <= 2.0 * radius;
}

/// The outline of an ellipse.
struct EllipseForm {
  glm::dvec2 center, axis;
  double a, b;  ///< radii, along the axis and across
  double reach;
};

/// Nothing where the outline is of another kind or so degenerate that the forms say nothing.
std::optional<ParabolaForm> parabola_form(const OffsetShape& shape);
std::optional<EllipseForm> ellipse_form(const OffsetShape& shape);

}  // namespace mien
