#pragma once
// A smooth curve through points.

#include <mien/quad_bezier.h>

#include <span>
#include <vector>

namespace mien {

/// The centripetal Catmull-Rom curve through the points (C. Yuksel, S. Schaefer, J. Keyser, 2011: no
/// cusps, no loops within a segment), each segment as two quadratic pieces with its tangents at both
/// ends. A point on the axis goes on to its own mirror image, so that both halves meet smoothly.
/// No two points in a row are equal.
std::vector<QuadBezier> smooth_curve(std::span<const glm::dvec2> points, double twice_axis);

/// The straight lines between them, in the same form.
std::vector<QuadBezier> straight_curve(std::span<const glm::dvec2> points);

}  // namespace mien
