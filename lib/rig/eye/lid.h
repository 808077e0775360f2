#pragma once
// The edge of a lid: a quadratic Bézier between the canthi, cut into a smooth row of bends where the
// cornea pushes it.
//
// Cut at the parameters 0, 1/n … 1, a quadratic curve with points p0 p1 p2 is the quadratic B-spline with
// the bends D_i = f(i/n, (i+1)/n), i = 0 … n−1, where f is its polar form
//
//   f(a, b) = (1−a)(1−b) p0 + (a(1−b) + b(1−a)) p1 + a b p2
//
// and f(t, t) is the curve. The curve passes halfway between neighbouring bends and stays smooth however
// they are moved, so a bulge can travel along a lid without a kink.

#include <mien/feature.h>
#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>

#include <array>
#include <span>

namespace mien {

/// f(a, b) of a curve.
inline glm::dvec2 polar_form(const QuadBezier& edge, double a, double b) {
  return (1 - a) * (1 - b) * edge.p0 + (a * (1 - b) + b * (1 - a)) * edge.p1 + a * b * edge.p2;
}

/// The share of a movement of the bend p1 that the point f(a, b) makes.
constexpr double bend_share(double a, double b) {
  return a * (1 - b) + b * (1 - a);
}

using LidBends = std::array<glm::dvec2, OpeningFigure::kLidBends>;

/// The bends of an edge.
LidBends lid_bends(const QuadBezier& edge);

/// The smooth row of quadratic pieces with these bends between two canthi.
using LidPieces = std::array<QuadBezier, OpeningFigure::kLidBends>;
LidPieces pieces_between(glm::dvec2 inner, const LidBends& bends, glm::dvec2 outer);

/// The shift of the point f(a, b) of the edge when its bends are shifted: that of the smooth row at (a +
/// b)/2, which is 0 at the canthi.
glm::dvec2 shift_along(std::span<const glm::dvec2, OpeningFigure::kLidBends> shifts, double a,
                       double b);

/// The parameter, 0 … 1, of the point of an edge that is nearest to `p`, to 1e-9.
double nearest_parameter(const QuadBezier& edge, glm::dvec2 p);

}  // namespace mien
