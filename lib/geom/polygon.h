#pragma once
// Closed outlines of straight sides: what is inside, how deep, how large.

#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>
#include <vector>

namespace mien {

/// Its last point is joined to its first.
using Polygon = std::vector<glm::dvec2>;

/// The winding number of the outline about a point: counterclockwise turns (where y points up) count as
/// positive.
int turns_around(const Polygon& outline, glm::dvec2 p);

/// The distance from a point to the outline; infinite if the outline is empty.
double way_to_outline(const Polygon& outline, glm::dvec2 p);

/// The same, negative where the outline does not run around the point.
double depth_inside(const Polygon& outline, glm::dvec2 p);

/// Positive for a counterclockwise outline (where y points up).
double signed_area(const Polygon& outline);

/// Appends `pieces` points of a curve at equal steps of its parameter, from its first point to one step
/// before its last.
void add_curve(const QuadBezier& curve, int pieces, Polygon& to);

/// The distance from a point to the straight line from a to b; `share` is where on it the nearest point
/// is, 0 … 1.
double way_to_side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p, double& share);

}  // namespace mien
