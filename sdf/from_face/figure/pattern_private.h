#pragma once
// The figures of a pattern, with the numbers it has in a face, as shapes: their union is the feature.
//
// A figure's place is found on the pattern's own patch or line first, by its number alone, and only then in the
// face. So a figure goes with the pattern however it is posed, and none appears or vanishes on the way.

#include <mien/face.h>
#include <mien/feature.h>
#include <mien/shape.h>

#include <vector>

namespace mien {

/// At least one shape each.
std::vector<Shape> pattern_shapes(const ScatterFigure& figure, const Face& face);
std::vector<Shape> pattern_shapes(const RepeatFigure& figure, const Face& face);
std::vector<Shape> pattern_shapes(const StripesFigure& figure, const Face& face);

}  // namespace mien
