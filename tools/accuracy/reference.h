#pragma once
// The true distances, in binary128. Coordinates are taken as exact; directions ("unit") are brought
// to length 1.
//
// Method. Half the slope of the squared distance is a polynomial in the outline's parameter; its sign
//   changes are bracketed (roots.h), and the distance is the least of those there and at the ends. An
//   error in the parameter enters at second order only, and a pair of roots that cancelled to no sign
//   change is no minimum. Ellipses by bisection of the secular equation, strokes by a sequence of
//   such quartics.
// Error. Below 2⁻¹⁰⁰ of the largest coordinate.

#include "tools/accuracy/families.h"
#include "tools/accuracy/quad.h"

namespace mien::accuracy {

Quad true_distance(const QuadBezier& curve, glm::dvec2 p);
Quad true_distance(const Ellipse& ellipse, glm::dvec2 p);
Quad true_distance(const ParabolaSide& side, glm::dvec2 p);
Quad true_distance(const TaperedStroke& stroke, glm::dvec2 p);
Quad true_distance(const CubicBezier& curve, glm::dvec2 p);
Quad true_distance(const Case& k);

}  // namespace mien::accuracy
