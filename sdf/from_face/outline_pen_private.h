#pragma once
// A line along the outline of one figure, as of a pen that is pressed and lifted.

#include <mien/face.h>
#include <mien/feature.h>
#include <mien/shape.h>

#include <vector>

namespace mien {

/// The line's pieces: their union is the line. `thin` wide where an outline begins and ends, `thick` half-way
/// round; between them by a parabola in the share of the way. None for figures without such an outline
/// (docs/face-format.md).
std::vector<Shape> outline_pen(const Figure& figure, const Face& face, double thin, double thick);

}  // namespace mien
