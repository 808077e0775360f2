#pragma once
// A feature's figure, with the numbers it has in a face, as a shape.

#include <mien/face.h>
#include <mien/feature.h>
#include <mien/shape.h>

#include <vector>

namespace mien {

/// Total: every figure of a valid face that is one shape has it, in the face's units; an empty path stands for
/// what is made of several, the core for a rounded rectangle (corner_of).
Shape shape_of(const Figure& figure, const Face& face);

/// The pieces of a stroke along the edge of a lid that is pushed out of its plain curve, of a smooth
/// polyline, of a pattern: their union is the figure. None if the figure is one shape.
std::vector<Shape> pieces_of(const Figure& figure, const Face& face);

/// The radius of its corners: its figure is all within that of its core.
double corner_of(const RoundedFigure& figure, const Face& face);

/// Whether two figures are of one kind and have the same numbers: then they have the same shape.
bool same_figure(const Figure& a, const Figure& b, const Face& face);

}  // namespace mien
