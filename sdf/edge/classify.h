#pragma once
// Where many squares lie against a shape: wholly inside, wholly outside, or perhaps crossed by its
// outline. The first question a renderer asks (edges_near answers the second).
//
//   const mien::Classifier lid(shape, origin);          // what depends on the shape alone, once
//   lid.classify(xs, ys, half_diagonal, sides);         // 16 squares take about as long as one
//
// Units.    Those of the shape. Centres are floats relative to `origin`, which is a double: a
//           picture of any size loses nothing if the origin is near the squares.
// Proof.    −1 and +1 are certain, float rounding included; 0 promises nothing. Half-planes, discs,
//           lines, quadratic strokes, parabola sides and ellipses are decided to within the rounding
//           (2⁻²⁰ of the coordinates) and half_diagonal² times the outline's largest curvature;
//           strokes of varying width to within 2·(rate of the width along the spine)·width.
//           docs/derivations/classify.md.
// Totality. Any shape and any numbers; a centre that is not finite gives 0.

#include <mien/lib/base/api.h>
#include <mien/sdf/edge/classify_frame.h>
#include <mien/sdf/edge/edge.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace mien {

class Classifier {
 public:
  MIEN_API Classifier(const OffsetShape& shape, glm::dvec2 origin);

  /// sides[i] = −1 if the square around origin + (x[i], y[i]) lies inside the shape, +1 if outside,
  /// 0 if it may be crossed. A square is known by half its diagonal alone: any turn of it will do.
  /// Spans of the same length.
  MIEN_API void classify(std::span<const float> x, std::span<const float> y, float half_diagonal,
                         std::span<std::int8_t> sides) const;

 private:
  ClassifyFrame frame_;
};

}  // namespace mien
