#pragma once
// The signed distance of a scene's area, in pixels: what gradients along an outline and reliefs
// read.

#include <mien/scene.h>
#include "sdf/shape/shape_distances.h"

#include <memory>
#include <span>
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
  Outward outward(glm::dvec2 p) const { return outward(p, nodes_); }

  /// What of the tree decides somewhere in the disc: of two operands one alone, where the other is farther by more than
  /// both can change.
  void narrow(glm::dvec2 middle, double radius, std::vector<Node>& to) const;
  /// The same by what of the tree decides there.
  Outward outward(glm::dvec2 p, std::span<const Node> nodes) const;

  /// The same of one of its shapes.
  double of_shape(std::size_t shape, glm::dvec2 p) const {
    return asked_->at(shape, shapes_[shape], p);
  }

  const std::vector<Shape>& shapes() const { return shapes_; }
  /// Operands before users; the last is the area. Of Op::shape, `a` is an index into shapes().
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  double tree_at(glm::dvec2 p, std::span<const Node> nodes, double* values) const;

  std::vector<Shape> shapes_;
  std::unique_ptr<ShapeDistances> asked_;
  std::vector<Node> nodes_;  ///< operands before users; the last is the area
};

}  // namespace mien
