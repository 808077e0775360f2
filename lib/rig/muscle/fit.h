#pragma once
// The inverse of posing: the pulls that bring the points of a face nearest to where they are wanted.
//
// Finds the pulls in [0, 1] that make Σ |p(pulls) − wanted|² least, where p is the equilibrium. It uses the
// Gauss-Newton method: each step is a linear least squares problem within the bounds
// (lib/math/bounded_least_squares.h), damped as by Levenberg and Marquardt. It starts twice, at rest and
// half pulled, and keeps the better result: a local minimum, or what 60 steps came to. The residual tells
// how good it is. Where several muscles could do the same, those that need not pull do not.

#include <mien/face_model.h>

#include <functional>
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
  double rms = 0;             ///< [face units] root mean square of the distances left
  double largest = 0;         ///< [face units] of them
  int farthest = -1;          ///< the slice of the point that far away
};

/// Targets that no muscle holds add to the residual and change nothing else. `told`: how far it is, from 0 to 1.
MuscleFit fit_muscles(const Face& face, std::span<const PointTarget> targets,
                      const std::function<void(double)>& told = {});

}  // namespace mien
