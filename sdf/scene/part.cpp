#include "sdf/scene/part.h"

#include <algorithm>

namespace mien {

Scene ScenePart::make(const Scene& whole, std::span<const PartLayer> layers, const Canvas& canvas) {
  SceneBuilder build(canvas, whole.background());
  whole_ = &whole, build_ = &build;
  known_.clear(), shapes_.clear(), open_.clear();
  everywhere_ = {};
  build.light(whole.light());
  for (const PartLayer& one : layers) {
    const Layer& layer = whole.layers()[std::size_t(one.layer)];
    open_groups_of(layer.group);
    const Area area = one.in == PartLayer::In::own     ? copy(layer.area)
                      : one.in == PartLayer::In::steps ? made_of(one.steps)
                                                       : everywhere();
    build.layer(layer.name, area, copy(layer.paint));
  }
  open_groups_of(-1);
  return std::move(build).finish();
}

/// Closes and opens until `group` is the innermost. Clips are in the areas already.
void ScenePart::open_groups_of(int group) {
  chain_.clear();
  for (int g = group; g >= 0; g = whole_->groups()[std::size_t(g)].parent) chain_.push_back(g);
  std::reverse(chain_.begin(), chain_.end());
  std::size_t same = 0;
  while (same < open_.size() && same < chain_.size() && open_[same] == chain_[same]) ++same;
  for (; open_.size() > same; open_.pop_back()) build_->close_group();
  for (; same < chain_.size(); ++same) {
    const Group& g = whole_->groups()[std::size_t(chain_[same])];
    build_->open_group(g.name, g.opacity, {}, g.mix);
    open_.push_back(chain_[same]);
  }
}

Area ScenePart::everywhere() {
  if (everywhere_.node < 0) everywhere_ = build_->everywhere();
  return everywhere_;
}

Area ScenePart::shape(int index) {
  Area& known = shapes_[index];
  if (known.node < 0) known = build_->shape(whole_->shapes()[std::size_t(index)]);
  return known;
}

Area ScenePart::made_of(std::span<const PartStep> steps) {
  stack_.clear();
  for (const PartStep& step : steps) {
    if (step.op == Op::shape) {
      const Area own = shape(step.shape);
      stack_.push_back(step.level == 0.0 ? own : build_->offset(own, step.level));
      continue;
    }
    const Area last = stack_.back();
    if (step.op == Op::complement) {
      stack_.back() = build_->complement(last);
      continue;
    }
    stack_.pop_back();
    stack_.back() = step.op == Op::unite ? build_->unite(stack_.back(), last)
                                         : build_->intersect(stack_.back(), last);
  }
  return stack_.back();
}

/// Operands first, by a stack of its own: trees may be deep.
Area ScenePart::copy(Area area) {
  if (area.node < 0) return area;
  todo_.assign(1, area.node);
  while (!todo_.empty()) {
    const int at = todo_.back();
    const Node& n = whole_->nodes()[std::size_t(at)];
    const auto waits_for = [&](int operand) {
      if (operand < 0 || known_.count(operand)) return false;
      todo_.push_back(operand);
      return true;
    };
    if (known_.count(at)) {
      todo_.pop_back();
      continue;
    }
    if (n.op == Op::shape) {
      known_[at] = shape(n.a);
    } else {
      const bool waits_a = waits_for(n.a), waits_b = waits_for(n.b);
      if (waits_a || waits_b) continue;
      const Area a = known_[n.a], b = n.b >= 0 ? known_[n.b] : Area{};
      known_[at] = n.op == Op::unite        ? build_->unite(a, b)
                   : n.op == Op::intersect  ? build_->intersect(a, b)
                   : n.op == Op::subtract   ? build_->subtract(a, b)
                   : n.op == Op::complement ? build_->complement(a)
                   : n.op == Op::offset     ? build_->offset(a, n.amount)
                                            : build_->shell(a, n.amount);
    }
    todo_.pop_back();
  }
  return known_[area.node];
}

Paint ScenePart::copy(const Paint& paint) {
  Paint made = paint;
  if (paint.relief && paint.relief->area.node >= 0) {
    Relief relief = *paint.relief;
    relief.area = copy(relief.area);
    made.relief = shared(std::move(relief));
  }
  if (paint.gradient)
    if (const auto* along = std::get_if<DistanceGradient>(&paint.gradient->along)) {
      Gradient gradient = *paint.gradient;
      gradient.along = DistanceGradient{copy(along->area), along->from, along->to};
      made.gradient = shared(std::move(gradient));
    }
  return made;
}

}  // namespace mien
