#pragma once
#include "sdf/outline/curve/curve_pen.h"

#include <glm/vec2.hpp>

namespace mien {

/// Arcs of ellipses center + cos φ u + sin φ v, u and v conjugate half-axes, by quadratic curves.
///
/// Derivation.  Such a curve over the angle h, with the arc's tangents at its ends, leaves the unit
///   circle outwards by e(h)·16 s²(1 − s)², e(h) = (c + 1/c)/2 − 1, c = cos(h/2), about h⁴/128: its
///   mean is 8/15 e. Drawn by 1 − 8/15 e smaller, it encloses the arc's own area, and is never
///   farther than 8/15 e from it. So it is beside ends that are given, by its control point alone. docs/derivations/outlines.md
/// Error.  At most the pen's tolerance.

/// The whole ellipse, from +x towards +y whichever way u and v turn. Nothing where it has no area.
void write_ellipse(CurvePen& pen, glm::dvec2 center, glm::dvec2 u, glm::dvec2 v);

/// From pen.at(), which is center + radius·from, turning by `turn` [rad], to `to`.
void write_arc(CurvePen& pen, glm::dvec2 center, double radius, glm::dvec2 from, double turn,
               glm::dvec2 to);

inline void write_disc(CurvePen& pen, glm::dvec2 center, double radius) {
  write_ellipse(pen, center, {radius, 0.0}, {0.0, radius});
}

}  // namespace mien
