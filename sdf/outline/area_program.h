#pragma once
// What is inside an area, as a small program on bits: one bit per outline, and, or and not.
//
// CSG is resolved on bits, never on distances, so abutting areas of a union leave no seam. With f the
// area's distance by its CSG tree, "f <= level" is pushed down to single shapes, whose offsets and
// level lines are outlines of their own:
//
// unite, intersect: to both operands       complement: −a <= v  is  not (a <= −v)
//   offset m:     a <= v + m                shell m:    |a| <= v + m =: k  is  a <= k and not (a <= −k)

#include <mien/scene.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mien {

/// One step of a program, in postfix order.
struct AreaStep {
  enum class Kind : unsigned char { outline, nothing, not_, and_, or_ } kind;
  int outline = 0;  ///< index into AreaPrograms::outlines
};

/// A range of steps. An empty one: everywhere.
struct AreaProgram {
  int first = 0, count = 0;
};

/// What an outline bounds: {distance(shape) <= amount}, or for a rim {|distance(shape)| <= amount}.
struct OutlineSource {
  int shape;      ///< index into Scene::shapes; beyond them, of the shapes added
  double amount;  ///< [face units]
  bool rim;       ///< OutlineMaker::rim of that half-width
  int count = 1;  ///< of a row of strokes: `shape` and those that follow it
};

/// The programs of a scene's areas. A shape at one level is one outline, even if it stands in the scene several
/// times; so is a row of united strokes, each of which begins where the one before ends and is as wide there.
class AreaPrograms {
 public:
  /// Begins again; memory is kept. The scene must outlive its use here.
  void begin(const Scene& scene);

  /// The program of {distance(area) <= level}; level in face units.
  AreaProgram add(Area area, double level = 0.0);

  /// The program of a shape that is not the scene's, in its units.
  AreaProgram add(Shape shape);

  /// The shape of an outline, of a row the first: the scene's, for rims Scene::outlined_shape, or one of those added.
  const Shape& shape(const OutlineSource& of) const;

  /// For every outline the one among another scene's that is made from the same numbers, or −1. Their order stays.
  void find_same(const AreaPrograms& others, std::vector<int>& same) const;

  std::span<const AreaStep> steps() const { return steps_; }
  std::span<const AreaStep> steps(const AreaProgram& of) const {
    return std::span(steps_).subspan(std::size_t(of.first), std::size_t(of.count));
  }
  std::span<const OutlineSource> outlines() const { return outlines_; }

 private:
  struct Task {  ///< a node to write next, or a step
    int node = -1;
    double level = 0.0;
    AreaStep::Kind kind{};
    int row = 0, count = 0;  ///< or a row: its first shape, how many
  };
  void find_alike();
  void expand(int node, double level);
  bool row(int node, double level);
  void leaf(int index, double level);
  void outline(int shape, double amount, bool rim, int count = 1);
  int& at_level(const OutlineSource& source);
  int added(Shape shape);
  bool same(int outline, const AreaPrograms& others, int other) const;
  void step(AreaStep::Kind kind) { steps_.push_back({kind}); }

  const Scene* scene_ = nullptr;
  std::vector<AreaStep> steps_;
  std::vector<OutlineSource> outlines_;
  std::vector<Shape> added_;
  std::vector<Task> todo_;
  std::vector<int> alike_;                             ///< by shape: the first that is the same
  std::vector<std::pair<std::uint64_t, int>> hashes_;  ///< of shapes
  std::vector<int> filled_;                            ///< by shape: its outline at level 0
  std::vector<int> at_levels_;  ///< the other outlines, by hash, open addressing; −1: free
  std::size_t leveled_ = 0;     ///< how many
};

}  // namespace mien
