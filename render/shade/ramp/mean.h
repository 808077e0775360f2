#pragma once
// Means of a ramp over a pixel or a part of one, by cells in each of which its place is a plane.

#include "render/cover/part_form.h"
#include "render/shade/ramp/integral.h"

#include <span>
#include <vector>

namespace mien {

/// side × side cells of a pixel, row by row: the place in each, scaled (RampIntegral::scaled), from its middle on.
struct RampCells {
  int side = 1;
  std::vector<RampPlane> planes;
};

/// The mean colour over all of a pixel.
Mix ramp_mean(const RampIntegral& ramp, const RampCells& cells);

/// The mean colour over the part of a pixel that chords bound.
Mix ramp_mean(const RampIntegral& ramp, const RampCells& cells, std::span<const PartChord> chords);

}  // namespace mien
