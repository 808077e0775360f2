#pragma once
// Random reliefs over one shape or a combination, in pixels, for the tests of render/shade.

#include "render/shade/paint.h"

#include "tests/support/random/random.h"

namespace mien::test {

/// A paint and the distance it refers to; its origin is the picture's top left corner.
struct LitScene {
  std::vector<AreaDistance> distances;
  GridPaint paint;
};

/// `size`: of the shape [px]. Kinds 0 … 7: stroke, path with corners, ellipse, disc, line, triangle,
/// stroke of one width, union of two discs.
constexpr int kLitShapes = 8;
AreaDistance random_area(Random& random, int kind, double size);
LitScene random_lit(Random& random, int kind, double size, Profile profile, Blend blend);

}  // namespace mien::test
