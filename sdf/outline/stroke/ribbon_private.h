#pragma once
#include <mien/quad_bezier.h>
#include "sdf/outline/outline_loop.h"

#include <span>
#include <vector>

namespace mien {

/// All points within `width` of a chain of curves, as one loop: along its right rim, around its
/// end, back along its left and around its begin. Each side begins where the one before ends; a
/// chain that is closed is one whose ends lie on each other.
///
/// Derivation.  Around corners the rim goes by an arc outside, through the vertex inside. The loop
///   winds around p as often as the part of the chain within `width` of p has pieces, and once more
///   for each inside of a corner that holds p: never where there is none. Rims that turn back on
///   themselves need nothing of their own. docs/derivations/outlines.md
void write_ribbon(OutlineLoop& loop, std::span<const QuadBezier> sides, double width);

/// The same along straight lines; `sides` is scratch.
void write_polyline(OutlineLoop& loop, std::span<const glm::dvec2> points, double width,
                    std::vector<QuadBezier>& sides);

}  // namespace mien
