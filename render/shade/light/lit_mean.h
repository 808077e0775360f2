#pragma once
// Means of a lit surface by division: slow, and relied on where quicker means do not serve.

#include "render/cover/part_form.h"
#include "render/shade/light/lit_surface.h"

namespace mien {

/// The mean over the square with that corner and side, all of it treated as that piece. Divided, four times at most,
/// until Gauss's four places and those of the four quarters agree within `tolerance` (of 1, in the blending space).
Mix square_mean(const LitSurface& surface, const LitPiece& piece, glm::dvec2 corner, double side,
                double tolerance);

/// The mean over a part of the pixel with that corner: by cells, ever finer until three means agree within the
/// tolerance, else by squares in place of 16 × 16 cells.
Mix part_mean(const LitSurface& surface, const LitPiece& piece, glm::dvec2 corner,
              const PartForm& form, double tolerance);

}  // namespace mien
