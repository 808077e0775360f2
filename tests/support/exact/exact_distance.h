#pragma once
// The signed distance of a scene's areas, with outlines of paths by their definition (exact_outline.h) instead of the
// scene's.

#include <mien/scene.h>

#include <map>
#include <optional>
#include <vector>

#include "tests/support/exact/exact_outline.h"

namespace mien::test {

/// Not for several threads: it remembers. Shapes have truths of their own in tests/sdf; the scene answers where no side
/// of an area's paths is hidden.
class ExactDistance {
 public:
  /// The scene must outlive this.
  explicit ExactDistance(const Scene& scene);

  double operator()(Area area, glm::dvec2 p) const;

 private:
  double of_shape(int shape, glm::dvec2 p) const;

  const Scene& scene_;
  std::vector<std::optional<ExactOutline>> outlines_;  ///< by shape, where they matter
  bool any_ = false;
  mutable std::map<int, std::vector<int>> needed_;  ///< by area: its nodes, operands first
  mutable std::vector<double> values_;              ///< by node
};

}  // namespace mien::test
