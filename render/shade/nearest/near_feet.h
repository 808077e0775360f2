#pragma once
// An area's distance inside one small disc, with its gradient and the bend of its level lines, at many places at
// once.
//
// An outline is a set of *spines*: curves B(t) with a half-width w(t), whose distance is the least |p − B(t)| −
// w(t). Sides of paths are spines without width, whose sign is that of the side. Around a tile only those stretches
// of spines are kept that can be nearest somewhere in it. Each place evaluates them at several parameters, their
// *samples*. Newton's method starts at the nearest sample, and at the nearest other one that is no neighbour of it: so
// a second foot that appears inside the tile is found.

#include "render/shade/nearest/area_distance.h"
#include "sdf/shape/curve/path_tree.h"

#include <optional>
#include <span>
#include <vector>

namespace mien {

/// A quadratic piece: x = x0 + t (x1 + t x2), likewise y and the half-width w.
template <class T>
struct Spine {
  T x0, x1, x2, y0, y1, y2, w0, w1, w2;
  T begin_x, begin_y, end_x,
      end_y;  ///< of a path: outward, between this side's normal and the next's
  T side;     ///< of a path: outward is side · (y', −x'); strokes: 0
};

inline glm::dvec2 on_spine(const Spine<double>& s, double t) {
  return {s.x0 + t * (s.x1 + t * s.x2), s.y0 + t * (s.y1 + t * s.y2)};
}

/// A stretch of a spine around a tile's middle.
struct NearSpine {
  Spine<float> spine;
  static constexpr int kMostSamples = 64;
  int samples;        ///< how many places along it are evaluated
  float first, step;  ///< their parameters
  bool single;        ///< nowhere in the disc does it have two feet
  float least;        ///< a lower bound of its distance at the middle
  float apart;        ///< how much nearer it may come between two samples
  bool line = false;  ///< straight and without width: its foot needs no search
};

/// An ellipse in its own frame, seen from a tile's middle.
struct NearEllipse {
  float x, y;    ///< its centre
  float ux, uy;  ///< unit, along `a`
  float a, b;
};

/// d and its gradient; bend: how fast the gradient turns along the level line [1/px].
struct Feet {
  float *d, *nx, *ny, *bend;
};

/// A shape as spines.
struct SpineShape {
  bool slow = false;     ///< no spines: distances are asked for one by one
  bool crosses = false;  ///< spines may cross each other
  std::optional<Ellipse> ellipse;
  bool stroke = false;
  std::vector<Spine<double>> spines;
  std::vector<double> reach;      ///< by spine: |B'| + |w'| at most
  std::vector<std::size_t> next;  ///< by side of a path: the one that begins at its end
  /// Of a path of many sides that cross: its spines have no hand, and winding numbers say what is inside.
  std::optional<PathTree> tree;
};

/// What all tiles of a paint share.
class FeetArea {
 public:
  FeetArea() = default;
  /// `center`: where the area's origin lies in the picture.
  FeetArea(const AreaDistance& area, glm::dvec2 center) { make(area, center); }

  /// Made anew; memory is kept.
  void make(const AreaDistance& area, glm::dvec2 center);

  const AreaDistance* area() const { return area_; }
  glm::dvec2 center() const { return center_; }
  const std::vector<SpineShape>& shapes() const { return shapes_; }
  /// Whether ridges may lie a pixel apart: where several shapes meet and one is small, and in shells.
  bool is_fine() const { return fine_; }

 private:
  const AreaDistance* area_ = nullptr;
  glm::dvec2 center_{0.0};
  std::vector<SpineShape> shapes_;
  bool fine_ = false;
  Path pieces_;  ///< scratch
};

/// Keeps its scratch; one per thread.
class NearFeet {
 public:
  /// From now on answers are for the disc around `middle`, a place of the picture.
  void narrow(const FeetArea& area, glm::dvec2 middle, double radius);

  /// Whether spines in the disc may cross: then feet a pixel apart do not reveal what lies between.
  bool tangled() const { return tangled_; }

  /// Whether only one spine is near, and has one foot seen from anywhere in the disc: no ridges.
  bool is_single() const { return leaves_.size() == 1 && spines_.size() == 1 && spines_[0].single; }

  /// For places relative to the middle, a multiple of 16 of them.
  void at(std::span<const float> x, std::span<const float> y, const Feet& out);

  /// Distances of single shapes, and the time that finding them took.
  struct Work {
    long long distances = 0;
    double seconds = 0;
  };
  /// Where work is added up from now on.
  void tell(Work& work) { work_ = &work; }

 private:
  void combine_at(std::span<const float> x, std::span<const float> y, const Feet& out);
  /// Trees of fewer nodes are not pruned.
  static constexpr std::size_t kLargeTree = 32;
  void prune(std::span<const Node> nodes, glm::dvec2 middle, double radius, std::vector<Node>& to);
  std::span<const Node> nodes_around(std::span<const float> x, std::span<const float> y);
  void sign_by_windings(const PathTree& tree, std::span<const float> x, std::span<const float> y,
                        const Feet& out) const;
  struct Leaf {
    std::size_t shape;  ///< of the area's
    const SpineShape* spines;
    std::size_t first, count;  ///< in spines_
  };
  void narrow_shape(const SpineShape& shape);
  bool ends_beside(const SpineShape& shape, std::size_t index) const;
  void shape_at(const Leaf& leaf, std::span<const float> x, std::span<const float> y,
                const Feet& out);
  void slow_at(std::size_t shape, std::span<const float> x, std::span<const float> y,
               const Feet& out) const;

  const FeetArea* area_ = nullptr;
  Work* work_ = nullptr;
  glm::dvec2 middle_{0.0};
  double radius_ = 0;
  bool tangled_ = false;
  std::vector<Node>
      tree_;  ///< the area's, as far as it matters in the disc; of Op::shape, b is the leaf
  std::vector<Node> near_;  ///< likewise in a part of the disc
  std::vector<double> values_;
  std::vector<int> place_;
  std::vector<Leaf> leaves_;
  std::vector<NearSpine> spines_;
  std::vector<float> nodes_;  ///< [node][d, nx, ny, bend][place]
};

/// The least of the spines' distances at each place, with its gradient and bend.
void spine_feet(std::span<const NearSpine> spines, bool stroke, std::span<const float> x,
                std::span<const float> y, const Feet& out);

/// The same for an ellipse.
void ellipse_feet(const NearEllipse& ellipse, std::span<const float> x, std::span<const float> y,
                  const Feet& out);

}  // namespace mien
