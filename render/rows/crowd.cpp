#include "render/rows/crowd.h"
#include "render/shade/paint_table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr int kNarrowest = 8;           // [px] of a window: a dither's period
constexpr std::size_t kFewLayers = 24;  // layers: fewer are not worth another window
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

}  // namespace

void Crowd::make(const Scene& scene, const View& view, Depth depth) {
  scene_ = scene, view_ = view;
  const double tolerance = depth == Depth::u8 ? 1.0 / 255 : 32.0 / 65535;
  unseen_ = kUnseen * tolerance / (view.blend == Blend::linear ? 12.92 : 1.0);
  const auto map = grid_from_face(scene.canvas(), view);
  face_from_grid_ = inverse(map);
  layers_.clear();
  for (const Layer& layer : scene.layers()) {
    const Box2 box = scene.bounds(layer.area);
    Seen seen{.box = {}, .through = through(layer)};
    if (!box.empty()) seen.box = around(Box2{map(box.lo), map(box.lo)}, map(box.hi));
    if (!box.empty() && !(glm::length(seen.box.size()) < HUGE_VAL))  // 0 · ∞ among it
      seen.box = {glm::dvec2{-HUGE_VAL}, glm::dvec2{HUGE_VAL}};
    layers_.push_back(seen);
  }
}

void Crowd::each_window(int top, int bottom, const PixelRect& wanted, CrowdScratch& scratch,
                        const std::function<void(const CrowdWindow&)>& draw) const {
  const PixelRect strip{0, top, view_.width, bottom - top};
  if (scratch.lists.empty()) scratch.lists.resize(1);
  scratch.lists[0].clear();
  for (std::size_t i = 0; i < layers_.size(); ++i)
    if (meet(layers_[i].box, strip)) scratch.lists[0].push_back({int(i)});
  halve(strip, wanted, 0, scratch, draw);
}

/// lists[depth]: the layers that may be seen in the rectangle.
void Crowd::halve(const PixelRect& rect, const PixelRect& wanted, std::size_t depth,
                  CrowdScratch& scratch,
                  const std::function<void(const CrowdWindow&)>& draw) const {
  if (rect.x >= wanted.x + wanted.width || rect.x + rect.width <= wanted.x ||
      rect.y >= wanted.y + wanted.height || rect.y + rect.height <= wanted.y)
    return;
  if (scratch.lists.size() < depth + 2) scratch.lists.resize(depth + 2);
  look(rect, scratch.lists[depth], scratch.lists[depth + 1]);
  const bool wide = rect.width >= rect.height;
  const int side = wide ? rect.width : rect.height;
  if (scratch.lists[depth + 1].size() <= kFewLayers || side <= kNarrowest)
    return draw(window(rect, scratch.lists[depth + 1], scratch));
  int half = kNarrowest;
  while (2 * half < side) half *= 2;
  PixelRect first = rect, second = rect;
  (wide ? first.width : first.height) = half;
  (wide ? second.x : second.y) += half;
  (wide ? second.width : second.height) -= half;
  halve(first, wanted, depth + 1, scratch, draw);
  halve(second, wanted, depth + 1, scratch, draw);
}

/// From the top down, until what covers the rectangle hides everything below.
void Crowd::look(const PixelRect& rect, std::span<const PartLayer> among,
                 std::vector<PartLayer>& seen) const {
  const glm::dvec2 half{0.5 * rect.width, 0.5 * rect.height};
  const glm::dvec2 middle = face_from_grid_(glm::dvec2{rect.x, rect.y} + half);
  const double reach = (glm::length(half) + kBeyond) * face_from_grid_.scale();
  double shows = 1.0;
  seen.clear();
  for (std::size_t k = among.size(); k-- > 0 && shows > unseen_;) {
    PartLayer one = among[k];
    const Seen& layer = layers_[std::size_t(one.layer)];
    if (!one.covers && !meet(layer.box, rect)) continue;
    const glm::dvec2 size = layer.box.size();
    if (!one.covers && size.x >= rect.width && size.y >= rect.height) {  // it might cover all
      const double d = scene_.distance(scene_.layers()[std::size_t(one.layer)].area, middle);
      if (d > reach) continue;
      one.covers = d < -reach;
    }
    seen.push_back(one);
    if (one.covers) shows *= layer.through;
  }
  std::reverse(seen.begin(), seen.end());
}

CrowdWindow Crowd::window(const PixelRect& rect, std::span<const PartLayer> layers,
                          CrowdScratch& scratch) const {
  const glm::dvec2 a = face_from_grid_(glm::dvec2{rect.x, rect.y}),
                   b = face_from_grid_(glm::dvec2{rect.x + rect.width, rect.y + rect.height});
  const Canvas canvas{{glm::min(a, b), glm::max(a, b)}, scene_.canvas().y_up};
  CrowdWindow made{rect, scratch.part.make(scene_, layers, canvas), view_};
  double shows = 1.0;
  for (const PartLayer& layer : layers)
    if (layer.covers) shows *= layers_[std::size_t(layer.layer)].through;
  // Within a rounding: the other way round it is multiplied where they are left out.
  if (shows <= unseen_ * (1 + 1e-9))
    made.left_out = shows * (view_.blend == Blend::linear ? 12.92 : 1.0);
  made.view.width = rect.width, made.view.height = rect.height, made.view.region.reset();
  return made;
}

}  // namespace mien
