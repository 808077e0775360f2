#pragma once
// An area as spines: what its distance is the least of. Every shape has them: arcs of ellipses as pieces of parabolas,
// within 3e-4 px.

#include "render/shade/nearest/area_distance.h"
#include "sdf/distance/feet/branches.h"
#include "sdf/shape/curve/path_tree.h"

#include <optional>
#include <vector>

namespace mien {

struct ShapeSpines {
  bool slow = false;  ///< it has no outline, and yet distances
  SpineList list;
  /// Of a path whose sides cross: they have no outside, and winding numbers say what is inside.
  std::optional<PathTree> tree;
};

/// What all places share.
class FeetArea {
 public:
  FeetArea() = default;
  /// `center`: where the area's origin lies in the picture.
  FeetArea(const AreaDistance& area, glm::dvec2 center) { make(area, center); }

  /// Made again; memory is kept.
  void make(const AreaDistance& area, glm::dvec2 center);

  const AreaDistance* area() const { return area_; }
  glm::dvec2 center() const { return center_; }
  const std::vector<ShapeSpines>& shapes() const { return shapes_; }

 private:
  const AreaDistance* area_ = nullptr;
  glm::dvec2 center_{0.0};
  std::vector<ShapeSpines> shapes_;
  Path pieces_;  ///< scratch
  std::vector<QuadBezier> sides_;
};

}  // namespace mien
