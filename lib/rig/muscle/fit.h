#pragma once
// Fitting back: which pulls bring the points of a face nearest to where they are wanted.
//
// The pulls in [0, 1] that make Σ |p(pulls) − wanted|² least, p being the equilibrium: by Gauss and
// Newton's method, each step a linear least squares problem within the bounds
// (lib/math/bounded_least_squares.h), damped as Levenberg and Marquardt do, from two starts (at rest,
// and half pulled), the better of which counts. A local minimum, or what 60 steps came to: the residual
// says how good it is. Where
// several muscles could do the same, those that need not pull do not.

#include <mien/face_model.h>

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// Where a point that muscles hold is wanted.
struct PointTarget {
  int slice;
  glm::dvec2 wanted;
};

struct MuscleFit {
  std::vector<double> pulls;  ///< of the model's muscles, 0 … 1
  double rms = 0;             ///< [the canvas's] of the distances left
  double largest = 0;         ///< [the canvas's] of them
  int farthest = -1;          ///< the slice that is off by it
};

/// Targets that no muscle holds add to the residual and change nothing else.
MuscleFit fit_muscles(const Face& face, std::span<const PointTarget> targets);

}  // namespace mien
