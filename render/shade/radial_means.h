#pragma once
// The places along a radial gradient of a pixel's cells, in lanes.

#include "render/shade/paint.h"

namespace mien {

/// field.mean(p + (dx, dy), variance) of a radial field, rounded to float: the same bits. Reads and writes whole vectors.
void radial_means(const PaintField& field, glm::dvec2 p, double variance, const float* dx,
                  const float* dy, int count, float* t);

}  // namespace mien
