#pragma once
// Means of a lit surface by division: the sure and slow way.

#include <mien/render/shade/lit_surface.h>

namespace mien {

/// The mean over the square with that corner and side, all of it taken as `zone`. Divided until
/// Gauss's four places and those of the four quarters agree within `tolerance` (of 1, in the
/// blending space), seven times at most.
Mix square_mean(const LitSurface& surface, int zone, glm::dvec2 corner, double side,
                double tolerance);

/// The mean over a part of the pixel with that corner: what lies in `zone`, and of that the side of
/// a straight cut that makes area and centroid right. What the cut leaves wrong of the centroid is
/// put right by the colours' slope.
Mix part_mean(const LitSurface& surface, int zone, glm::dvec2 corner, double area,
              glm::dvec2 centroid, int places);

}  // namespace mien
