#include <mien/render/rows/crowd.h>
#include <mien/render/shade/paint_table.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr int kNarrowest = 16;    // [px] of a window: a multiple of a dither's period
constexpr std::size_t kFew = 24;  // layers: fewer are not worth another window
constexpr double kBeyond = 2.0;   // [px] around a window that its outlines may see

bool meet(const Box2& box, const PixelRect& r) {
  return box.lo.x < r.x + r.width + kBeyond && box.hi.x > r.x - kBeyond &&
         box.lo.y < r.y + r.height + kBeyond && box.hi.y > r.y - kBeyond;
}

bool is_opaque(const Layer& layer) {
  const Paint& p = layer.paint;
  const auto all = [](const std::vector<Stop>& stops) {
    return std::all_of(stops.begin(), stops.end(), [](const Stop& s) { return s.color.a >= 1.0; });
  };
  return layer.group < 0 && p.color.a >= 1.0 && (!p.gradient || all(p.gradient->stops));
}

}  // namespace

void Crowd::make(const Scene& scene, const View& view) {
  scene_ = scene, view_ = view;
  const auto map = grid_from_face(scene.canvas(), view);
  face_from_grid_ = inverse(map);
  layers_.clear();
  for (const Layer& layer : scene.layers()) {
    const Box2 box = scene.bounds(layer.area);
    Seen seen{.box = {}, .opaque = is_opaque(layer)};
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
    if (meet(layers_[i].box, strip)) scratch.lists[0].push_back(int(i));
  halve(strip, wanted, 0, scratch, draw);
}

/// lists[depth]: the layers that may be seen in the rectangle.
void Crowd::halve(const PixelRect& rect, const PixelRect& wanted, std::size_t depth,
                  CrowdScratch& scratch,
                  const std::function<void(const CrowdWindow&)>& draw) const {
  if (rect.x >= wanted.x + wanted.width || rect.x + rect.width <= wanted.x) return;
  if (scratch.lists.size() < depth + 2) scratch.lists.resize(depth + 2);
  look(rect, scratch.lists[depth], scratch.lists[depth + 1]);
  if (scratch.lists[depth + 1].size() <= kFew || rect.width <= kNarrowest)
    return draw(window(rect, scratch.lists[depth + 1], scratch));
  int half = kNarrowest;
  while (2 * half < rect.width) half *= 2;
  halve({rect.x, rect.y, half, rect.height}, wanted, depth + 1, scratch, draw);
  halve({rect.x + half, rect.y, rect.width - half, rect.height}, wanted, depth + 1, scratch, draw);
}

/// From the top down, until one covers all.
void Crowd::look(const PixelRect& rect, std::span<const int> among, std::vector<int>& seen) const {
  const glm::dvec2 half{0.5 * rect.width, 0.5 * rect.height};
  const glm::dvec2 middle = face_from_grid_(glm::dvec2{rect.x, rect.y} + half);
  const double reach = (glm::length(half) + kBeyond) * face_from_grid_.scale();
  seen.clear();
  for (std::size_t k = among.size(); k-- > 0;) {
    const auto i = std::size_t(among[k]);
    if (!meet(layers_[i].box, rect)) continue;
    const double d = scene_.distance(scene_.layers()[i].area, middle);
    if (d > reach) continue;
    seen.push_back(among[k]);
    if (d < -reach && layers_[i].opaque) break;
  }
  std::reverse(seen.begin(), seen.end());
}

CrowdWindow Crowd::window(const PixelRect& rect, std::span<const int> layers,
                          CrowdScratch& scratch) const {
  const glm::dvec2 a = face_from_grid_(glm::dvec2{rect.x, rect.y}),
                   b = face_from_grid_(glm::dvec2{rect.x + rect.width, rect.y + rect.height});
  const Canvas canvas{{glm::min(a, b), glm::max(a, b)}, scene_.canvas().y_up};
  CrowdWindow made{rect, scratch.part.make(scene_, layers, canvas), view_};
  made.view.width = rect.width, made.view.height = rect.height, made.view.region.reset();
  return made;
}

}  // namespace mien
