#pragma once
// An area's distance inside one small disc: what of its shapes can matter there, and that at many
// places at once.
//
// Distances are 1-Lipschitz, so over a disc of radius r each changes by at most r either way. With one
// value at the centre: of two operands of a min the one that is larger by more than 2 r is never
// the smaller one in the disc, and of a path's sides those farther than the nearest one by more
// than 2 r are never nearest. What is left is mostly one side of one path.

#include <mien/render/tile/area_distance.h>

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

/// Keeps its scratch; one per thread.
class NearArea {
 public:
  /// From now on: the disc around `center`.
  void narrow(const AreaDistance& area, glm::dvec2 center, double radius);

  /// d[i] = the distance at center + (x[i], y[i]), a place of the disc; by the float batches of
  /// sdf/distance.h, in coordinates from the centre: as exact as those say for the shapes left.
  void distances(std::span<const float> x, std::span<const float> y, std::span<float> d);

  /// The same at one place, in double precision, of the picture's coordinates.
  double at(glm::dvec2 p) const;

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t side_count() const { return sides_.size(); }

 private:
  /// A shape of the area, as much of it as matters.
  struct Part {
    const Shape* shape;
    const Path* path = nullptr;  ///< then its nearest sides, in sides_
    std::size_t first = 0, count = 0;
    double sign = 0;  ///< ±1 all over the disc; 0: by the winding number
  };
  enum class Uses : unsigned char { nothing, shape, all, a_alone, b_alone, not_b };
  void choose(const AreaDistance& area);
  int add_shape(const Shape& shape, double here);
  double value(int node) const { return values_[std::size_t(node)]; }
  double part_at(const Part& part, glm::dvec2 p) const;
  void part_distances(const Part& part, std::span<const float> x, std::span<const float> y,
                      std::span<float> d);

  glm::dvec2 center_{0.0};
  double radius_ = 0;
  std::vector<double> values_;  ///< of the area's nodes, at the centre
  std::vector<int> place_;      ///< of the area's nodes in nodes_; −1: not there yet
  std::vector<Uses> uses_;      ///< the area's nodes make of their operands
  int sole_ = -1;               ///< in nodes_: the area
  std::vector<Node> nodes_;     ///< operands before users; Op::shape: `a` is an index into parts_
  std::vector<Part> parts_;
  std::vector<QuadBezier> sides_;   ///< of the picture's coordinates
  std::vector<QuadBezier> local_;   ///< from the centre
  std::vector<float> node_values_;  ///< [node][place]
};

}  // namespace mien
