#pragma once
// A path's sides in a tree of boxes, made once, for paths that are asked for many distances: a place then asks the few
// sides around it.
//
//   const PathTree tree(path);
//   tree.distance(p);   // distance(path, p), and
//   tree.winding(p);    // winding(path, p), in about log n of the n sides
//
// The plane around the path is halved again and again, until few sides are left in each part. Every part knows the
// winding number of one place in it, its *mark*: from there to p only the part's own sides can change it, first along
// y, then along x. Each way goes by the rule that decides what lies right of p, of sides as they are and turned.

#include <mien/box2.h>
#include <mien/quad_bezier.h>
#include <mien/shape.h>
#include "sdf/shape/outward.h"

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

class PathTree {
 public:
  /// Paths of fewer sides are asked side by side just as fast.
  static constexpr std::size_t kFewSides = 24;

  explicit PathTree(const Path& path);

  /// As of the path itself, up to a rounding.
  double distance(glm::dvec2 p) const;
  /// With the gradient of the nearest side; infinite without one.
  Outward outward(glm::dvec2 p) const;
  int winding(glm::dvec2 p) const;
  bool inside(glm::dvec2 p) const;

  std::size_t sides() const { return sides_.size(); }
  /// Held by it.
  std::size_t bytes() const;

 private:
  struct Nearest {
    double distance;  ///< unsigned
    int side;         ///< −1: there is none, or p is infinite
  };
  Nearest nearest(glm::dvec2 p) const;
  struct Part {
    Box2 box;
    int first = 0, count = 0;  ///< sides, in `listed_`
    int child = -1;            ///< the first of two; −1: it is not halved
    int axis = 0;              ///< across which it is
    int depth = 0;
    glm::dvec2 mark{0.0};
    int winding = 0;  ///< of the mark
    int beyond = 0;   ///< passes of the part's turned sides beyond the mark
  };
  /// A side, or a quarter of one that bends: the box of its control points, and these.
  struct Stretch {
    Box2 box;
    QuadBezier curve;
  };
  void add_stretches(const QuadBezier& side);
  bool is_bent(int side) const {
    const auto i = std::size_t(side);
    return first_stretch_[i + 1] - first_stretch_[i] > 1;
  }
  bool meets(int side, const Box2& box) const;
  bool halve(int part);
  void set_mark(int part, int outer);
  int winding_in(const Part& part, glm::dvec2 p) const;
  int winding_of_all(glm::dvec2 p) const;
  std::span<const int> sides_of(const Part& part) const {
    return std::span(listed_).subspan(std::size_t(part.first), std::size_t(part.count));
  }

  FillRule rule_;
  std::vector<QuadBezier> sides_, turned_;  ///< turned: x and y exchanged
  std::vector<Stretch> stretches_;
  std::vector<int> first_stretch_;  ///< by side
  std::vector<Box2> boxes_;         ///< by side
  double slack_ = 0;                ///< more than coordinates are rounded by
  std::vector<Part> parts_;         ///< the first is all
  std::vector<int> listed_;
};

}  // namespace mien
