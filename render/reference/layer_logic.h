#pragma once
// Which layers may be seen in a square, and which shapes decide it: by signed distances alone.
//
// A layer's area {f <= 0} is said by single shapes, as in any CSG tree: with levels pushed down to
// them it is an expression over sets {distance(shape) <= level}. One distance at a square's middle
// says of a set that it holds all of the square, nothing or part of it, since distances are
// 1-Lipschitz; expressions shrink to what is left open, and layers under an opaque one are dropped.
// So the smaller the square, the shorter the question.
//
// Not the programs that pictures are drawn by (sdf/outline/area_program.h), which this judges.

#include <mien/scene.h>

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace mien {

/// {distance(shape) <= level}.
struct LevelSet {
  int shape;     ///< index into Scene::shapes
  double level;  ///< [face units]
};

/// How much of a square a set holds.
enum class Reach : unsigned char { none, part, whole };

struct LogicStep {
  enum class Kind : unsigned char { set, not_, and_, or_ } kind;
  int set = -1;  ///< index into LayerLogic::sets
};

/// A layer that may be seen, and the expression that says where, as a range of LayerLogic's steps;
/// no steps: everywhere.
struct LiveLayer {
  int layer;
  int first, count;
};

/// Scopes within scopes: all of the picture, a part of it, a part of that.
class LayerLogic {
 public:
  /// `covers[i]`: whether nothing is seen below layer i where it is. The scene must outlive this.
  LayerLogic(const Scene& scene, std::vector<char> covers);

  struct Scope {
    int first_layer, layers;  ///< of `live`
    int first_step;
    int first_open, open;  ///< of `open_sets`
  };
  const Scope& whole_picture() const { return whole_; }

  /// What is left of a scope in a square. `reach(set)` says how much of the square a set holds, and is asked once
  /// for each set. Scopes end in the opposite order, by `leave`.
  template <class ReachOf>
  Scope enter(const Scope& outer, ReachOf&& reach) {
    return enter(outer, reach, [&](int layer) { return covers_[std::size_t(layer)] != 0; });
  }
  /// The same, where `hides(layer)` says of a layer that holds all of the square, from the top down, whether nothing
  /// below it is seen.
  template <class ReachOf, class Hides>
  Scope enter(const Scope& outer, ReachOf&& reach, Hides&& hides);
  void leave(const Scope& scope);

  std::span<const LevelSet> sets() const { return sets_; }
  /// Bottom to top.
  std::span<const LiveLayer> live(const Scope& s) const {
    return std::span(live_).subspan(std::size_t(s.first_layer), std::size_t(s.layers));
  }
  /// A live layer's expression.
  std::span<const LogicStep> steps(const LiveLayer& layer) const {
    return std::span(steps_).subspan(std::size_t(layer.first), std::size_t(layer.count));
  }
  /// The sets that decide: each holds part of the scope.
  std::span<const int> open_sets(const Scope& s) const {
    return std::span(open_).subspan(std::size_t(s.first_open), std::size_t(s.open));
  }
  /// Whether a layer is where the sets in `inside` (by set, not 0) are.
  bool holds(const LiveLayer& layer, const std::vector<char>& inside);

 private:
  void expand(const Node& node, double level);
  void leaf(int shape, double level);
  void write(LogicStep::Kind kind) { steps_.push_back({kind}); }
  void write_program(Area area);
  void begin_scope(Scope& scope, const Scope& outer);
  void end_scope(Scope& scope);
  template <class ReachOf>
  Reach shrink(int first, int count, ReachOf&& reach);
  void combine(LogicStep::Kind kind);

  const Scene& scene_;
  std::vector<char> covers_;  ///< by layer
  std::vector<LevelSet> sets_;
  std::map<std::pair<int, double>, int> known_;
  Scope whole_{};

  std::vector<LogicStep> steps_;  ///< of all scopes, one after the other
  std::vector<LiveLayer> live_;
  std::vector<int> open_;
  std::vector<int> seen_;  ///< by set: the scope that it was last asked for
  std::vector<Reach> reach_;
  int scopes_ = 0;

  struct Task {  ///< a node to write next, or a step
    int node = -1;
    double level = 0.0;
    LogicStep::Kind kind{};
  };
  std::vector<Task> todo_;
  struct Part {  ///< of an expression that shrinks: what is left of it
    Reach reach;
    int first;
  };
  std::vector<Part> parts_;
  std::vector<char> bits_;
};

template <class ReachOf>
Reach LayerLogic::shrink(int first, int count, ReachOf&& reach) {
  parts_.clear();
  for (int i = first; i < first + count; ++i) {
    const LogicStep step = steps_[std::size_t(i)];
    if (step.kind != LogicStep::Kind::set) {
      combine(step.kind);
      continue;
    }
    const auto s = std::size_t(step.set);
    if (seen_[s] != scopes_) seen_[s] = scopes_, reach_[s] = reach(step.set);
    parts_.push_back({reach_[s], int(steps_.size())});
    if (reach_[s] == Reach::part) steps_.push_back(step);
  }
  return parts_.empty() ? Reach::whole : parts_.back().reach;
}

template <class ReachOf, class Hides>
LayerLogic::Scope LayerLogic::enter(const Scope& outer, ReachOf&& reach, Hides&& hides) {
  Scope scope;
  begin_scope(scope, outer);
  for (int i = outer.first_layer + outer.layers; i-- > outer.first_layer;) {
    const LiveLayer layer = live_[std::size_t(i)];
    const int first = int(steps_.size());
    const Reach held = shrink(layer.first, layer.count, reach);
    if (held == Reach::none) continue;
    live_.push_back({layer.layer, first, int(steps_.size()) - first});
    if (held == Reach::whole && hides(layer.layer)) break;
  }
  end_scope(scope);
  return scope;
}

}  // namespace mien
