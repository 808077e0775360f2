#pragma once
// Visible fragments of an arrangement with two looks, inside and outside → the loops that bound the inside.
//
// At every height at which fragments end, what is inside just above it and what is inside just below differ by
// intervals whose ends are the fragments' ends. Sorted from left to right these ends pair off: each pair is joined by
// a level side, of no length where one fragment goes on in another. So loops close by counting, whatever the
// rounding of places.

#include "sdf/arrange/sweep.h"

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// A side of a loop, from where the side before it ends.
struct LoopSide {
  glm::dvec2 control, to;
  bool straight;  ///< the control point does not count
};

/// It ends where it starts, and has the inside on its left as the picture is seen (y down).
struct FragmentLoop {
  glm::dvec2 start;
  std::vector<LoopSide> sides;
};

/// Look 1 is inside, look 0 outside; there are no others. Sides that are parts of one parabola or line again become
/// one where that moves nothing by more than `tolerance` [px], and level sides shorter than that vanish.
std::vector<FragmentLoop> fragment_loops(std::span<const Fragment> fragments,
                                         std::span<const OutlinePiece> pieces, double tolerance);

}  // namespace mien
