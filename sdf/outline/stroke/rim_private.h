#pragma once
// The rims of a stroke: the sheets of the envelope of its discs, drawn by quadratic curves.

#include "sdf/outline/outline_loop.h"

#include "pen_private.h"

namespace mien {

/// A point of a rim: E(t) = B(t) + w(t) n(t), n·B' = −w', n left of the spine or right of it.
struct Rim {
  double t;
  glm::dvec2 point, normal;
  glm::dvec2 way;  ///< unit, across the normal, along the spine
  double speed;  ///< |B'|² − w'² − w (n·B'' + w''): > 0 where the rim runs along `way`, < 0 where
                 ///< it runs back, 0 at its cusps
};

/// The sine of the angle by which normals lean backwards because the width grows.
double lean_at(const Pen& pen, double t);

/// toward: +1 left of the spine (towards turned(B')), −1 right of it.
Rim rim_at(const Pen& pen, double toward, double t);

/// From loop.at(), which is from.point, along the rim to to.point. Everywhere between them |w'| <= |B'| and w >= 0.
///
/// Fit.   The quadratic curve Q that has the rim's points and tangents at both ends. With t linear
///        in Q's parameter s,
///            |Q(s) − B(t(s))|² − w(t(s))² = c s² (1 − s)²    exactly, c = |Q''/2 − B''/2|² −
///            (w''/2)²,
///        so one number tells how far Q leaves the disc at t(s). How much deeper it is in a
///        neighbouring disc follows from the derivative along t, s (1 − s)(α + β s), and the second
///        one, a quadratic. docs/derivations/outlines.md
/// Pieces. Cut where x or y turns; between turns as many as the integral of the fourth root of the error's leading
///        term asks for, at equal shares of it.
/// Error. At most the loop's tolerance, proven for each piece; pieces halve until it is.
void write_rim(OutlineLoop& loop, const Pen& pen, double toward, const Rim& from, const Rim& to);

}  // namespace mien
