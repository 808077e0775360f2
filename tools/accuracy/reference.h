#pragma once
// The true distances, in binary128. Coordinates are taken as exact.
//
// Method. Half the slope of |B(t) − p|² is a polynomial in t; its sign changes in [0, 1] are
// bracketed
//   (roots.h), and the distance is the least of those at the sign changes and at the ends. An error
//   in t enters at second order only, and a pair of roots that cancelled to no sign change is no
//   minimum.
// Error. Below 2⁻¹⁰⁰ of the largest coordinate.

#include <mien/lib/geom/quad_bezier.h>

#include <mien/tools/accuracy/quad.h>

namespace mien::accuracy {

Quad true_distance(const QuadBezier& curve, glm::dvec2 p);

}  // namespace mien::accuracy
