#pragma once
// The outline of a path by its definition: all places of its sides with the inside on one hand and the outside on the
// other. By winding numbers alone, slowly.

#include <mien/shape.h>

#include <optional>
#include <vector>

namespace mien::test {

class ExactOutline {
 public:
  explicit ExactOutline(const Path& path);

  /// Signed, to the outline. +infinity if the path has none.
  double distance(glm::dvec2 p) const;

  /// Stretches of sides, in the order of the sides.
  const std::vector<QuadBezier>& stretches() const { return stretches_; }
  /// Stretches that have inside on both hands, or outside.
  const std::vector<QuadBezier>& hidden() const { return hidden_; }

 private:
  Path path_;
  std::vector<QuadBezier> stretches_, hidden_;
};

}  // namespace mien::test
