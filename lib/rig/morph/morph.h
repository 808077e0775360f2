#pragma once
// How far a posed face is from its rest shape, point by point: what heat maps show.

#include <mien/api.h>
#include <mien/face.h>

#include <glm/vec2.hpp>
#include <vector>

namespace mien {

/// One point of a face, at rest and posed.
struct PointShift {
  int slice;  ///< of the layout
  glm::dvec2 from, to;
  double amount;  ///< how far it has gone [face units]
};

/// All points of the face vector, in its order. `posed` is the same face, posed.
MIEN_API std::vector<PointShift> point_shifts(const Face& rest, const Face& posed);

/// The largest amount; 0 if there are none.
MIEN_API double largest_shift(const std::vector<PointShift>& shifts);

}  // namespace mien
