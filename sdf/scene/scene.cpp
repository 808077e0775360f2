#include <mien/scene.h>
#include "sdf/csg/combine.h"
#include "sdf/shape/shape_distances.h"
#include "sdf/shape/shape_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mien {
namespace {

/// The nodes `area` needs, operands before users. Iterative: chains may be a hundred thousand long.
std::vector<int> nodes_under(std::span<const Node> nodes, Area area) {
  std::vector<char> needed(std::size_t(area.node) + 1, 0);
  needed[std::size_t(area.node)] = 1;
  for (int i = area.node; i >= 0; --i) {
    const Node& n = nodes[std::size_t(i)];
    if (!needed[std::size_t(i)] || n.op == Op::shape) continue;
    needed[std::size_t(n.a)] = 1;
    if (n.b >= 0) needed[std::size_t(n.b)] = 1;
  }
  std::vector<int> list;
  for (int i = 0; i <= area.node; ++i)
    if (needed[std::size_t(i)]) list.push_back(i);
  return list;
}

/// Runs `leaf` and `inner` over the nodes under `area` and gives the last value.
template <class Value, class Leaf, class Inner>
Value fold(std::span<const Node> nodes, Area area, Leaf leaf, Inner inner) {
  const Node& root = nodes[std::size_t(area.node)];
  if (root.op == Op::shape) return leaf(root.a);
  std::vector<Value> value(std::size_t(area.node) + 1);
  for (int i : nodes_under(nodes, area)) {
    const Node& n = nodes[std::size_t(i)];
    value[std::size_t(i)] = n.op == Op::shape ? leaf(n.a)
                                              : inner(n, value[std::size_t(n.a)],
                                                      value[std::size_t(n.b < 0 ? n.a : n.b)]);
  }
  return value[std::size_t(area.node)];
}

/// Whether all points and widths are numbers. The planes' and parabolas' may be without end.
struct IsFinite {
  bool of(double v) const { return std::isfinite(v); }
  bool of(glm::dvec2 p) const { return of(p.x) && of(p.y); }
  bool of(const QuadBezier& c) const { return of(c.p0) && of(c.p1) && of(c.p2); }
  template <class List>
  bool all(const List& list) const {
    return std::all_of(std::begin(list), std::end(list), [&](const auto& v) { return of(v); });
  }
  bool operator()(const Disc& s) const { return of(s.center) && of(s.radius); }
  bool operator()(const CutDisc& s) const { return of(s.center) && of(s.radius); }
  bool operator()(const Ellipse& s) const { return of(s.center) && of(s.radii) && of(s.axis); }
  bool operator()(const Triangle& s) const { return of(s.a) && of(s.b) && of(s.c); }
  bool operator()(const Line& s) const { return of(s.a) && of(s.b) && of(s.half_width); }
  bool operator()(const Polyline& s) const { return all(s.points) && of(s.half_width); }
  bool operator()(const QuadStroke& s) const { return of(s.spine) && of(s.half_width); }
  bool operator()(const TaperedStroke& s) const { return of(s.spine) && all(s.half_width); }
  bool operator()(const Path& s) const {
    return std::all_of(s.loops.begin(), s.loops.end(),
                       [&](const Path::Loop& l) { return all(l.sides); });
  }
  template <class Other>
  bool operator()(const Other&) const {
    return true;
  }
};

}  // namespace

SceneBuilder::SceneBuilder(Canvas canvas, Color background) {
  data_.canvas = canvas;
  data_.background = background;
}

Area SceneBuilder::add(Node node) {
  data_.nodes.push_back(node);
  return {int(data_.nodes.size()) - 1};
}

Area SceneBuilder::shape(Shape shape) {
  if (!std::visit(IsFinite{}, shape)) shape = Path{};
  data_.shapes.push_back(std::move(shape));
  return add({.op = Op::shape, .a = int(data_.shapes.size()) - 1});
}

Area SceneBuilder::unite(Area a, Area b) {
  return add({.op = Op::unite, .a = a.node, .b = b.node});
}
Area SceneBuilder::intersect(Area a, Area b) {
  return add({.op = Op::intersect, .a = a.node, .b = b.node});
}
Area SceneBuilder::subtract(Area a, Area b) {
  return add({.op = Op::subtract, .a = a.node, .b = b.node});
}
Area SceneBuilder::complement(Area a) {
  return add({.op = Op::complement, .a = a.node});
}

Area SceneBuilder::offset(Area a, double amount) {
  return add({.op = Op::offset, .a = a.node, .amount = amount});
}

Area SceneBuilder::shell(Area a, double amount) {
  return add({.op = Op::shell, .a = a.node, .amount = amount});
}

Area SceneBuilder::everywhere() {
  return complement(shape(Path{}));
}

Area SceneBuilder::moved(Area a, glm::dvec2 by) {
  std::vector<int> at(std::size_t(a.node) + 1, -1);
  for (const int i : nodes_under(data_.nodes, a)) {
    Node n = data_.nodes[std::size_t(i)];
    if (n.op == Op::shape) {
      data_.shapes.push_back(transformed(glm::dmat2{1.0}, by, data_.shapes[std::size_t(n.a)]));
      n.a = int(data_.shapes.size()) - 1;
    } else {
      n.a = at[std::size_t(n.a)];
      if (n.b >= 0) n.b = at[std::size_t(n.b)];
    }
    at[std::size_t(i)] = add(n).node;
  }
  return {at[std::size_t(a.node)]};
}

void SceneBuilder::layer(std::string name, Area area, Paint paint) {
  const int group = open_.empty() ? -1 : open_.back().group;
  if (!open_.empty() && open_.back().clip.node >= 0) area = intersect(area, open_.back().clip);
  data_.layers.push_back({std::move(name), area, std::move(paint), group});
}

void SceneBuilder::open_group(std::string name, double opacity, Area clip, MixMode mix) {
  const OpenGroup outer = open_.empty() ? OpenGroup{-1, {}} : open_.back();
  if (clip.node < 0)
    clip = outer.clip;
  else if (outer.clip.node >= 0)
    clip = intersect(clip, outer.clip);
  data_.groups.push_back({std::move(name), outer.group, opacity, mix});
  open_.push_back({int(data_.groups.size()) - 1, clip});
}

void SceneBuilder::close_group() {
  open_.pop_back();
}

Scene SceneBuilder::finish() && {
  Scene scene;
  data_.asked = std::make_shared<const ShapeDistances>(data_.shapes.size());
  data_.outlines = std::make_shared<const ShapeOutlines>(data_.shapes.size());
  scene.data_ = std::make_shared<const Scene::Data>(std::move(data_));
  return scene;
}

double Scene::distance(Area area, glm::dvec2 p) const {
  return fold<double>(
      nodes(), area, [&](int i) { return shape_distance(std::size_t(i), p); },
      [](const Node& n, double a, double b) { return combine(n.op, a, b, n.amount); });
}

double Scene::shape_distance(std::size_t shape, glm::dvec2 p) const {
  return data_->asked->at(shape, outlined_shape(shape), p);
}

const Shape& Scene::outlined_shape(std::size_t shape) const {
  return data_->outlines->of(shape, data_->shapes[shape]);
}

Exactness Scene::exactness(Area area) const {
  return fold<Exactness>(
      nodes(), area, [&](int i) { return mien::exactness(outlined_shape(std::size_t(i))); },
      [](const Node& n, Exactness a, Exactness b) {
        return combine_exactness(n.op, a, b, n.amount);
      });
}

Box2 Scene::bounds(Area area) const {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const Box2 everywhere{{-kInf, -kInf}, {kInf, kInf}};
  return fold<Box2>(
      nodes(), area, [&](int i) { return mien::bounds(data_->shapes[std::size_t(i)]); },
      [&](const Node& n, const Box2& a, const Box2& b) -> Box2 {
        switch (n.op) {
          case Op::unite:
            return around(a, b);
          case Op::intersect:
            return common(a, b);
          case Op::complement:
            return everywhere;
          case Op::offset:
            return n.amount > 0 && !a.empty() ? grown(a, n.amount) : a;
          case Op::shell:
            return a.empty() ? everywhere : grown(a, std::max(n.amount, 0.0));
          case Op::shape:
          case Op::subtract:
            return a;
        }
        return everywhere;
      });
}

}  // namespace mien
