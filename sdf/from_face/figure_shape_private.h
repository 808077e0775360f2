#pragma once
// A feature's figure, with the numbers it has in a face, as a shape.

#include <mien/face.h>
#include <mien/feature.h>
#include <mien/shape.h>

#include <vector>

namespace mien {

/// Total: every figure of a valid face has a shape, in the face's units.
Shape shape_of(const Figure& figure, const Face& face);

/// The pieces of a stroke along the edge of a lid that is pushed out of its plain curve, or of a smooth
/// polyline: their union is the stroke. None if the figure is one shape.
std::vector<Shape> pieces_of(const Figure& figure, const Face& face);

/// Whether two figures are of one kind and have the same numbers: then they have the same shape.
bool same_figure(const Figure& a, const Figure& b, const Face& face);

}  // namespace mien
