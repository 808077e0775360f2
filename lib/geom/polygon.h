#pragma once
// Closed outlines of straight sides: what is inside, how deep, how large.

#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>
#include <vector>

namespace mien {

/// Its last point is joined to its first.
using Polygon = std::vector<glm::dvec2>;

/// How often the outline runs around a point, counterclockwise (where y points up) counted up.
int turns_around(const Polygon& outline, glm::dvec2 p);

/// From a point to the nearest point of the outline; infinite where there is none.
double way_to_outline(const Polygon& outline, glm::dvec2 p);

/// The same, counted down where the outline does not run around the point.
double depth_inside(const Polygon& outline, glm::dvec2 p);

/// Counterclockwise (where y points up) is positive.
double signed_area(const Polygon& outline);

/// Adds `pieces` points of a curve at equal steps of its parameter, its first one but not its last.
void add_curve(const QuadBezier& curve, int pieces, Polygon& to);

/// From a point to a straight line between two; `share`: where on it, 0 … 1.
double way_to_side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p, double& share);

}  // namespace mien
