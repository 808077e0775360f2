#pragma once
#include <mien/sdf/outline/outline_loop.h>

#include <glm/vec2.hpp>
#include <vector>

namespace mien {

/// All points within `half_width` of the polyline, as one loop: along its right side, around its
/// end and back along its left. `points` loses those that repeat the one before.
///
/// Derivation.  The strips of the pieces and the pies at the outer sides of the corners, each
///   bounded once the same way round, are the union; what their outlines have in common cancels,
///   and one loop is left: around each corner outside, through the vertex inside. So the winding
///   number is the number of strips and pies that hold a point. docs/derivations/outlines.md
void write_polyline(OutlineLoop& loop, std::vector<glm::dvec2>& points, double half_width);

}  // namespace mien
