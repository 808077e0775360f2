#pragma once
#include <mien/shape.h>
#include "sdf/outline/curve/curve_pen.h"

#include <vector>

namespace mien {

/// Sides without end are closed far enough around the pen's window; their numbers are in pixels.

void write_half_plane(CurvePen& pen, const HalfPlane& side);
void write_parabola_side(CurvePen& pen, const ParabolaSide& side);

/// The first side's closed outline, cut to the second side: where it leaves the second side, that side's own
/// outline leads to where it comes back in. Each loop is one part of the intersection.
void write_band(CurvePen& pen, const Band& band);

}  // namespace mien
