#pragma once
#include <mien/sdf/outline/outline_loop.h>
#include <mien/sdf/shape/shape.h>

#include <vector>

namespace mien {

/// Sides without end are closed far enough around the loop's window; their numbers are in pixels.

void write_half_plane(OutlineLoop& loop, const HalfPlane& side);
void write_parabola_side(OutlineLoop& loop, const ParabolaSide& side);

/// The first side's closed outline, cut to the second: where it leaves the second side, that one's
/// own outline leads from there to where it comes back. docs/derivations/outlines.md
void write_band(OutlineLoop& loop, const Band& band);

}  // namespace mien
