#include <mien/render/tile/scope.h>

#include <numeric>
#include <utility>

namespace mien {

using Kind = Step::Kind;

ScopeStack::ScopeStack(const Tape& tape)
    : tape_(tape), sides_(tape.outlines.size(), Side::unknown), used_(tape.outlines.size(), 0) {}

void ScopeStack::reset(const Mark& mark) {
  outlines_.resize(mark.outlines);
  layers_.resize(mark.layers);
  steps_.resize(mark.steps);
}

Scope ScopeStack::everything() {
  Scope scope{int(outlines_.size()), int(tape_.outlines.size()), int(layers_.size()),
              int(tape_.layers.size()), tape_.background};
  outlines_.resize(outlines_.size() + tape_.outlines.size());
  std::iota(outlines_.end() - scope.outline_count, outlines_.end(), 0);
  for (const TapeLayer& layer : tape_.layers) {
    const int first = int(steps_.size());
    steps_.insert(steps_.end(), tape_.steps.begin() + layer.first,
                  tape_.steps.begin() + layer.first + layer.count);
    layers_.push_back({first, layer.count, layer.mix, layer.paint, layer.group});
    scope.varied |= !layer.plain();
  }
  return scope;
}

Scope ScopeStack::of_layers(std::span<const int> layers) {
  Scope scope{int(outlines_.size()), 0, int(layers_.size()), int(layers.size()), tape_.background};
  for (const int index : layers) {
    const TapeLayer& layer = tape_.layers[std::size_t(index)];
    const int first = int(steps_.size());
    steps_.insert(steps_.end(), tape_.steps.begin() + layer.first,
                  tape_.steps.begin() + layer.first + layer.count);
    layers_.push_back({first, layer.count, layer.mix, layer.paint, layer.group});
    scope.varied |= !layer.plain();
    for (int i = first; i < first + layer.count; ++i)
      if (const Step& step = steps_[std::size_t(i)];
          step.kind == Kind::outline && !std::exchange(used_[std::size_t(step.outline)], char(1)))
        outlines_.push_back(step.outline);
  }
  scope.outline_count = int(outlines_.size()) - scope.first_outline;
  for (const int outline : outlines(scope)) used_[std::size_t(outline)] = 0;
  return scope;
}

/// Appends to steps_ what remains of a program when the known sides are put in. If nothing remains
/// the whole program is decided, and the answer says how.
Side ScopeStack::simplify(int first, int count) {
  partials_.clear();
  const auto decide = [&](std::size_t begin, Side side) {
    steps_.resize(begin);
    partials_.push_back({side, begin});
  };
  for (int i = first; i < first + count; ++i) {
    const Step step = steps_[std::size_t(i)];
    const std::size_t end = steps_.size();
    switch (step.kind) {
      case Kind::outline: {
        const Side side = sides_[std::size_t(step.outline)];
        if (side == Side::unknown) steps_.push_back(step);
        partials_.push_back({side, end});
        break;
      }
      case Kind::nothing:
        partials_.push_back({Side::out, end});
        break;
      case Kind::not_: {
        Partial& a = partials_.back();
        if (a.side == Side::unknown)
          steps_.push_back(step);
        else
          a.side = a.side == Side::in ? Side::out : Side::in;
        break;
      }
      case Kind::and_:
      case Kind::or_: {
        const Side ruling =
            step.kind == Kind::and_ ? Side::out : Side::in;  // decides whatever the other is
        const Partial b = partials_.back();
        partials_.pop_back();
        const Partial a = partials_.back();
        partials_.pop_back();
        if (a.side == ruling || b.side == ruling) {
          decide(a.begin, ruling);
        } else if (a.side !=
                   Side::unknown) {  // neutral: the other alone remains, and a had left no steps
          partials_.push_back({b.side, a.begin});
        } else if (b.side != Side::unknown) {
          partials_.push_back({a.side, a.begin});
        } else {
          steps_.push_back(step);
          partials_.push_back({Side::unknown, a.begin});
        }
        break;
      }
    }
  }
  return partials_.back().side;
}

void ScopeStack::forget_unused(Scope& scope) {
  for (int l = scope.first_layer; l < scope.first_layer + scope.layer_count; ++l) {
    const Layer& layer = layers_[std::size_t(l)];
    for (int i = layer.first; i < layer.first + layer.count; ++i)
      if (steps_[std::size_t(i)].kind == Kind::outline)
        used_[std::size_t(steps_[std::size_t(i)].outline)] = 1;
  }
  std::size_t kept = std::size_t(scope.first_outline);
  for (std::size_t i = kept; i < outlines_.size(); ++i) {
    const int outline = outlines_[i];
    if (!used_[std::size_t(outline)]) continue;
    used_[std::size_t(outline)] = 0;
    outlines_[kept++] = outline;
  }
  outlines_.resize(kept);
  scope.outline_count = int(kept) - scope.first_outline;
}

Scope ScopeStack::narrowed(const Scope& scope, glm::dvec2 center, double radius) {
  const std::size_t first_outline = outlines_.size();
  for (int i = 0; i < scope.outline_count; ++i) {
    const int outline = outlines_[std::size_t(scope.first_outline + i)];
    const double d = distance(tape_.outlines[std::size_t(outline)], center);
    const Side side = d > radius ? Side::out : d < -radius ? Side::in : Side::unknown;
    sides_[std::size_t(outline)] = side;
    if (side == Side::unknown) outlines_.push_back(outline);
  }
  if (int(outlines_.size() - first_outline) == scope.outline_count && !scope.varied) {
    outlines_.resize(first_outline);
    return scope;
  }
  Scope narrow{int(first_outline), 0, int(layers_.size()), 0, scope.base};
  int hidden = -1;  // a group whose other layers can't be seen
  for (int l = 0; l < scope.layer_count; ++l) {
    Layer layer = layers_[std::size_t(scope.first_layer + l)];
    if (hidden >= 0 && in_group(layer.group, hidden)) continue;
    const int first = int(steps_.size());
    const Side side = layer.count == 0 ? Side::in : simplify(layer.first, layer.count);
    if (side == Side::out) continue;
    if (layer.paint >= 0 && sampler) {
      if (const auto mix = sampler->constant(layer.paint, center, radius)) {
        layer.mix = *mix;
        layer.paint = -1;
        if (mix->a == 0.0) {
          steps_.resize(std::size_t(first));
          continue;
        }
      }
    }
    const bool hides = side == Side::in && layer.mix.a >= 1.0;
    if (hides && layer.paint < 0 && layer.group < 0) {  // everything below
      narrow.base = layer.mix;
      break;
    }
    layers_.push_back({first, int(steps_.size()) - first, layer.mix, layer.paint, layer.group});
    narrow.varied |= layer.paint >= 0 || layer.group >= 0;
    if (hides && layer.group < 0) break;
    if (hides) hidden = layer.group;
  }
  while (layers_.size() > std::size_t(narrow.first_layer) && layers_.back().count == 0 &&
         layers_.back().paint < 0 && layers_.back().group < 0) {
    narrow.base =
        over(layers_.back().mix, narrow.base);  // translucent and everywhere, at the bottom
    layers_.pop_back();
  }
  narrow.layer_count = int(layers_.size()) - narrow.first_layer;
  forget_unused(narrow);
  return narrow;
}

bool ScopeStack::in_group(int group, int ancestor) const {
  while (group > ancestor) group = tape_.groups[std::size_t(group)].parent;  // parents come first
  return group == ancestor;
}

/// Closes the groups that `group` is not in, each over what is collected around it, and opens those
/// it is in.
void ScopeStack::enter(int group) {
  while (group_ >= 0 && !in_group(group, group_)) {
    const TapeGroup& closed = tape_.groups[std::size_t(group_)];
    const Mix mix = group_mix_.back();
    group_mix_.pop_back();
    group_mix_.back() = over(group_mix_.back(), closed.opacity * mix);
    group_ = closed.parent;
  }
  const int depth = group < 0 ? 0 : tape_.groups[std::size_t(group)].depth;
  group_mix_.resize(std::size_t(depth) + 1, Mix{0.0});
  group_ = group;
}

bool ScopeStack::inside(const Layer& layer) {
  if (layer.count == 0) return true;
  bits_.clear();
  for (int i = layer.first; i < layer.first + layer.count; ++i) {
    const Step step = steps_[std::size_t(i)];
    switch (step.kind) {
      case Kind::outline:
        bits_.push_back(sides_[std::size_t(step.outline)] == Side::in);
        break;
      case Kind::nothing:
        bits_.push_back(0);
        break;
      case Kind::not_:
        bits_.back() = !bits_.back();
        break;
      case Kind::and_:
      case Kind::or_: {
        const char b = bits_.back();
        bits_.pop_back();
        bits_.back() = char(step.kind == Kind::and_ ? bits_.back() & b : bits_.back() | b);
        break;
      }
    }
  }
  return bits_.back();
}

Mix ScopeStack::color(const Scope& scope) {
  Mix mix{0.0};
  for (int l = 0; l < scope.layer_count && mix.a < 1.0; ++l) {
    const Layer& layer = layers_[std::size_t(scope.first_layer + l)];
    if (inside(layer)) mix = over(mix, layer.mix);
  }
  return mix.a < 1.0 ? over(mix, scope.base) : mix;
}

}  // namespace mien
