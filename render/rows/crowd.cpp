#include "render/rows/crowd.h"
#include "lib/base/watch.h"
#include "render/shade/paint_table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr int kNarrowest = 8;   // [px] of a window: a dither's period
constexpr int kFewLayers = 24;  // layers: fewer are not worth another window
constexpr int kFewSets = 96;    // likewise, of sets that their outlines part
/// [px] More than outlines may be off: what lies this far outside a window is not seen in it, and what reaches this
/// far around it covers it.
constexpr double kBeyond = 0.125;

bool meet(const Box2& box, const PixelRect& r) {
  return box.lo.x < r.x + r.width + kBeyond && box.hi.x > r.x - kBeyond &&
         box.lo.y < r.y + r.height + kBeyond && box.hi.y > r.y - kBeyond;
}

/// An upper bound of what shows through a layer anywhere; a layer in a group counts as transparent.
double through(const Layer& layer) {
  if (layer.group >= 0) return 1.0;
  double least = 1.0;
  if (layer.paint.gradient)
    for (const Stop& s : layer.paint.gradient->stops) least = std::min(least, s.color.a);
  return 1.0 - std::clamp(least * layer.paint.color.a, 0.0, 1.0);
}

PartStep part_step(const LayerLogic& logic, const LogicStep& step) {
  switch (step.kind) {
    case LogicStep::Kind::set: {
      const LevelSet& set = logic.sets()[std::size_t(step.set)];
      return {Op::shape, set.shape, set.level};
    }
    case LogicStep::Kind::not_:
      return {Op::complement};
    case LogicStep::Kind::and_:
      return {Op::intersect};
    case LogicStep::Kind::or_:
      return {Op::unite};
  }
  return {Op::shape};
}

}  // namespace

void Crowd::make(const Scene& scene, const View& view, Depth depth) {
  scene_ = scene, view_ = view;
  const double tolerance = depth == Depth::u8 ? 1.0 / 255 : 32.0 / 65535;
  unseen_ = kUnseen * tolerance / (view.blend == Blend::linear ? 12.92 : 1.0);
  const auto map = grid_from_face(scene.canvas(), view);
  face_from_grid_ = inverse(map);
  through_.clear(), boxes_.clear();
  for (const Layer& layer : scene_.layers()) through_.push_back(through(layer));
  logic_.emplace(scene_, std::vector<char>(scene_.layers().size(), 0));
  for (const LevelSet& set : logic_->sets()) {
    worked(200);
    Box2 box = bounds(scene_.shapes()[std::size_t(set.shape)]);
    if (!box.empty() && set.level > -HUGE_VAL) box = grown(box, set.level);
    if (!box.empty()) box = around(Box2{map(box.lo), map(box.lo)}, map(box.hi));
    if (!box.empty() && !(glm::length(box.size()) < HUGE_VAL))  // 0 · ∞ among it
      box = {glm::dvec2{-HUGE_VAL}, glm::dvec2{HUGE_VAL}};
    boxes_.push_back(box);
  }
}

void Crowd::each_window(int top, int bottom, const PixelRect& wanted, CrowdScratch& scratch,
                        const std::function<void(const CrowdWindow&)>& draw) const {
  scratch.logic.emplace(*logic_);
  halve({0, top, view_.width, bottom - top}, wanted, scratch.logic->whole_picture(), scratch, draw);
}

/// How much of the rectangle a set holds.
Reach Crowd::reach(const LevelSet& set, const Box2& box, const PixelRect& rect) const {
  if (!(set.level > -HUGE_VAL) || box.empty() || !meet(box, rect)) return Reach::none;
  const glm::dvec2 size = box.size();
  const bool narrow = size.x < rect.width || size.y < rect.height;  // it cannot cover all
  if (narrow && std::max(size.x, size.y) < 2.0 * std::max(rect.width, rect.height))
    return Reach::part;
  const glm::dvec2 half{0.5 * rect.width, 0.5 * rect.height};
  const glm::dvec2 middle = face_from_grid_(glm::dvec2{rect.x, rect.y} + half);
  const double reach = (glm::length(half) + kBeyond) * face_from_grid_.scale();
  const double d = scene_.shape_distance(std::size_t(set.shape), middle) - set.level;
  return d > reach ? Reach::none : d < -reach ? Reach::whole : Reach::part;
}

/// From the top down, until what covers the rectangle hides everything below.
Crowd::Scope Crowd::look(const PixelRect& rect, const Scope& outer, LayerLogic& logic) const {
  worked(20 * std::int64_t(outer.layers) + 60 * std::int64_t(outer.open));
  double shows = 1.0;
  return logic.enter(
      outer,
      [&](int set) {
        return reach(logic.sets()[std::size_t(set)], boxes_[std::size_t(set)], rect);
      },
      [&](int layer) {
        shows *= through_[std::size_t(layer)];
        return !(shows > unseen_);
      });
}

void Crowd::halve(const PixelRect& rect, const PixelRect& wanted, const Scope& outer,
                  CrowdScratch& scratch,
                  const std::function<void(const CrowdWindow&)>& draw) const {
  if (rect.x >= wanted.x + wanted.width || rect.x + rect.width <= wanted.x ||
      rect.y >= wanted.y + wanted.height || rect.y + rect.height <= wanted.y)
    return;
  const Scope scope = look(rect, outer, *scratch.logic);
  const bool wide = rect.width >= rect.height;
  const int side = wide ? rect.width : rect.height;
  if ((scope.layers <= kFewLayers && scope.open <= kFewSets) || side <= kNarrowest) {
    draw(window(rect, scope, scratch));
  } else {
    int half = kNarrowest;
    while (2 * half < side) half *= 2;
    PixelRect first = rect, second = rect;
    (wide ? first.width : first.height) = half;
    (wide ? second.x : second.y) += half;
    (wide ? second.width : second.height) -= half;
    halve(first, wanted, scope, scratch, draw);
    halve(second, wanted, scope, scratch, draw);
  }
  scratch.logic->leave(scope);
}

CrowdWindow Crowd::window(const PixelRect& rect, const Scope& scope, CrowdScratch& scratch) const {
  const glm::dvec2 a = face_from_grid_(glm::dvec2{rect.x, rect.y}),
                   b = face_from_grid_(glm::dvec2{rect.x + rect.width, rect.y + rect.height});
  const Canvas canvas{{glm::min(a, b), glm::max(a, b)}, scene_.canvas().y_up};
  const LayerLogic& logic = *scratch.logic;
  scratch.layers.clear(), scratch.steps.clear();
  std::size_t steps = 0;
  for (const LiveLayer& live : logic.live(scope)) steps += logic.steps(live).size();
  scratch.steps.reserve(steps);  // they stay where they are
  double shows = 1.0;
  for (const LiveLayer& live : logic.live(scope)) {
    PartLayer layer{live.layer, PartLayer::In::everywhere};
    const std::size_t first = scratch.steps.size();
    for (const LogicStep& step : logic.steps(live)) scratch.steps.push_back(part_step(logic, step));
    if (live.count == 0)
      shows *= through_[std::size_t(live.layer)];
    else
      layer.in = PartLayer::In::steps, layer.steps = std::span(scratch.steps).subspan(first);
    scratch.layers.push_back(layer);
  }
  CrowdWindow made{rect, scratch.part.make(scene_, scratch.layers, canvas), view_};
  // Within a rounding: the other way round it is multiplied where they are left out.
  if (shows <= unseen_ * (1 + 1e-9))
    made.left_out = shows * (view_.blend == Blend::linear ? 12.92 : 1.0);
  made.view.width = rect.width, made.view.height = rect.height, made.view.region.reset();
  return made;
}

}  // namespace mien
