#include "render/reference/layer_logic.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

using LogicKind = LogicStep::Kind;

/// Whether a set has no area: its distance is nowhere below its level.
struct HasNoArea {
  double level;
  bool thin(double half_width) const { return !(half_width + level > 0.0); }
  bool operator()(const Disc& s) const { return thin(s.radius); }
  bool operator()(const Ellipse& s) const { return thin(std::min(s.radii.x, s.radii.y)); }
  bool operator()(const CutDisc& s) const { return thin(s.radius); }
  bool operator()(const Line& s) const { return thin(s.half_width); }
  bool operator()(const Polyline& s) const { return thin(s.half_width); }
  bool operator()(const QuadStroke& s) const { return thin(s.half_width); }
  bool operator()(const TaperedStroke& s) const {
    return thin(std::max({s.half_width[0], s.half_width[1], s.half_width[2]}));
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

}  // namespace

LayerLogic::LayerLogic(const Scene& scene, std::vector<char> covers)
    : scene_(scene), covers_(std::move(covers)) {
  whole_.layers = int(scene.layers().size());
  for (int i = 0; i < whole_.layers; ++i) {
    const int first = int(steps_.size());
    write_program(scene.layers()[std::size_t(i)].area);
    live_.push_back({i, first, int(steps_.size()) - first});
  }
  known_.clear();
  seen_.assign(sets_.size(), -1);
  reach_.assign(sets_.size(), Reach::part);
}

/// Uses a stack of its own: trees may be a hundred thousand deep.
void LayerLogic::write_program(Area area) {
  if (area.node >= 0) todo_.push_back({.node = area.node});
  while (!todo_.empty()) {
    const Task task = todo_.back();
    todo_.pop_back();
    if (task.node < 0)
      write(task.kind);
    else
      expand(scene_.nodes()[std::size_t(task.node)], task.level);
  }
}

/// {f <= level}. The stack runs backwards: what is pushed last is written first.
void LayerLogic::expand(const Node& n, double level) {
  const auto next = [&](int node, double v) { todo_.push_back({.node = node, .level = v}); };
  const auto then = [&](LogicKind kind) { todo_.push_back({.kind = kind}); };
  switch (n.op) {
    case Op::shape:
      return leaf(n.a, level);
    case Op::unite:      // min(a, b) <= v
    case Op::intersect:  // max(a, b) <= v
      then(n.op == Op::unite ? LogicKind::or_ : LogicKind::and_);
      next(n.a, level);
      return next(n.b, level);
    case Op::subtract:  // max(a, −b) <= v: not b < −v
      then(LogicKind::and_), then(LogicKind::not_);
      next(n.b, -level);
      return next(n.a, level);
    case Op::complement:
      then(LogicKind::not_);
      return next(n.a, -level);
    case Op::offset:
      return next(n.a, level + n.amount);
    case Op::shell:  // −k <= a <= k
      then(LogicKind::and_), then(LogicKind::not_);
      next(n.a, -(level + n.amount));
      return next(n.a, level + n.amount);
  }
}

void LayerLogic::leaf(int shape, double level) {
  const bool none =
      !(level > -HUGE_VAL) || std::visit(HasNoArea{level}, scene_.shapes()[std::size_t(shape)]);
  const double known = none ? -HUGE_VAL : level;
  const auto [at, is_new] = known_.try_emplace({shape, known}, int(sets_.size()));
  if (is_new) sets_.push_back({shape, known});
  steps_.push_back({LogicKind::set, at->second});
}

void LayerLogic::begin_scope(Scope& scope, const Scope& outer) {
  ++scopes_;
  const auto room = std::size_t(outer.layers);
  live_.reserve(live_.size() + room);
  scope = {int(live_.size()), 0, int(steps_.size()), int(open_.size()), 0};
}

/// Layers were met from the top; what is open is gathered in the order of steps.
void LayerLogic::end_scope(Scope& scope) {
  scope.layers = int(live_.size()) - scope.first_layer;
  std::reverse(live_.begin() + scope.first_layer, live_.end());
  ++scopes_;
  for (std::size_t i = std::size_t(scope.first_step); i < steps_.size(); ++i)
    if (steps_[i].kind == LogicKind::set && seen_[std::size_t(steps_[i].set)] != scopes_) {
      seen_[std::size_t(steps_[i].set)] = scopes_;
      open_.push_back(steps_[i].set);
    }
  scope.open = int(open_.size()) - scope.first_open;
}

void LayerLogic::leave(const Scope& scope) {
  live_.resize(std::size_t(scope.first_layer));
  steps_.resize(std::size_t(scope.first_step));
  open_.resize(std::size_t(scope.first_open));
}

/// What is left of an operand stands at the end of the steps; of one that is decided, nothing.
void LayerLogic::combine(LogicKind kind) {
  if (kind == LogicKind::not_) {
    Reach& r = parts_.back().reach;
    if (r == Reach::part)
      steps_.push_back({LogicKind::not_});
    else
      r = r == Reach::whole ? Reach::none : Reach::whole;
    return;
  }
  const Reach ends = kind == LogicKind::and_ ? Reach::none : Reach::whole;
  const Part b = parts_.back();
  parts_.pop_back();
  Part& a = parts_.back();
  if (a.reach == ends || b.reach == ends) {
    steps_.resize(std::size_t(a.first));
    a.reach = ends;
  } else if (a.reach == Reach::part && b.reach == Reach::part) {
    steps_.push_back({kind});
  } else if (b.reach == Reach::part) {
    a.reach = Reach::part;
  }
}

bool LayerLogic::holds(const LiveLayer& layer, const std::vector<char>& inside) {
  bits_.clear();
  for (int i = layer.first; i < layer.first + layer.count; ++i) {
    const LogicStep step = steps_[std::size_t(i)];
    if (step.kind == LogicKind::set) {
      bits_.push_back(inside[std::size_t(step.set)]);
    } else if (step.kind == LogicKind::not_) {
      bits_.back() = !bits_.back();
    } else {
      const char b = bits_.back();
      bits_.pop_back();
      bits_.back() = step.kind == LogicKind::and_ ? bits_.back() & b : bits_.back() | b;
    }
  }
  return bits_.empty() || bits_.back();
}

}  // namespace mien
