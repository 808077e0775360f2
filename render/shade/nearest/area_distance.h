#pragma once
// The signed distance of a scene's area, in pixels: what gradients along an outline and reliefs
// read.

#include <mien/scene.h>
#include "sdf/shape/shape_distances.h"

#include <memory>
#include <vector>

namespace mien {

/// An area's CSG tree with its shapes in pixels. 1-Lipschitz.
class AreaDistance {
 public:
  AreaDistance(const Scene& scene, Area area, const Map<PixelSpace, FaceSpace>& map);
  AreaDistance() = default;

  /// Made anew; memory is kept. `place` is scratch.
  void make(const Scene& scene, Area area, const Map<PixelSpace, FaceSpace>& map,
            std::vector<int>& place);

  /// Negative inside; p in pixels, origin at the picture's centre.
  double at(glm::dvec2 p) const;
  /// With its gradient: on a ridge that of one side.
  Outward outward(glm::dvec2 p) const;

  /// The same of one of its shapes.
  double of_shape(std::size_t shape, glm::dvec2 p) const {
    return asked_->at(shape, shapes_[shape], p);
  }

  const std::vector<Shape>& shapes() const { return shapes_; }
  /// Operands before users; the last is the area. Of Op::shape, `a` is an index into shapes().
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  double tree_at(glm::dvec2 p, double* values) const;

  std::vector<Shape> shapes_;
  std::unique_ptr<ShapeDistances> asked_;
  std::vector<Node> nodes_;  ///< operands before users; the last is the area
};

}  // namespace mien
