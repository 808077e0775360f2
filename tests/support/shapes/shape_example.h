#pragma once
// Examples of shapes, the same for all laws: those of distances (shape_laws.h) and of outlines
// (outline_laws.h). Each kind has its own in tests/support/shape_examples.

#include <mien/shape.h>

#include <functional>
#include <vector>

namespace mien::test {

/// A shape and what the laws need to know of it.
template <class S>
struct Example {
  S shape;
  /// How far inside p is by the shape's definition, in any unit: > 0 inside, < 0 outside, ~0 on the
  /// outline. Independent of distance().
  std::function<double(glm::dvec2)> inside;
  double size = 3.0;    ///< points are taken from (−size, size)²
  bool hollow = false;  ///< has no inside at all: a point, a line, nothing
};

template <class S>
std::vector<Example<S>> examples();  // specialised in tests/support/shapes/shape_examples

/// The shape run backwards or with its equal parts swapped: the same points. Itself where there is
/// no such thing.
template <class S>
S backwards(S shape) {
  return shape;
}

}  // namespace mien::test
