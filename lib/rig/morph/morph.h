#pragma once
// Displacements of a posed face from rest, point by point, as heat maps show them.

#include <mien/api.h>
#include <mien/face.h>

#include <glm/vec2.hpp>
#include <vector>

namespace mien {

/// One point of a face, at rest and posed.
struct PointShift {
  int slice;  ///< of the layout
  glm::dvec2 from, to;
  double amount;  ///< its displacement [face units]
};

/// All points of the face vector, in its order. `posed` is the same face, posed.
MIEN_API std::vector<PointShift> point_shifts(const Face& rest, const Face& posed);

/// The largest amount; 0 if there are no points.
MIEN_API double largest_shift(const std::vector<PointShift>& shifts);

}  // namespace mien
