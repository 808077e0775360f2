#include "render/shade/nearest/area_distance.h"

#include "lib/base/watch.h"
#include "sdf/csg/combine.h"

#include <array>

namespace mien {

AreaDistance::AreaDistance(const Scene& scene, Area area, const Map<PixelSpace, FaceSpace>& map) {
  std::vector<int> place;
  make(scene, area, map, place);
}

void AreaDistance::make(const Scene& scene, Area area, const Map<PixelSpace, FaceSpace>& map,
                        std::vector<int>& place) {
  constexpr int kUnused = -2, kNeeded = -1;
  nodes_.clear();
  place.assign(std::size_t(area.node) + 1, kUnused);
  place[std::size_t(area.node)] = kNeeded;
  for (int i = area.node; i >= 0; --i) {
    const Node& n = scene.nodes()[std::size_t(i)];
    if (place[std::size_t(i)] == kUnused || n.op == Op::shape) continue;
    place[std::size_t(n.a)] = kNeeded;
    if (n.b >= 0) place[std::size_t(n.b)] = kNeeded;
  }
  std::size_t shapes = 0;
  for (int i = 0; i <= area.node; ++i) {
    if (place[std::size_t(i)] == kUnused) continue;
    Node n = scene.nodes()[std::size_t(i)];
    if (n.op == Op::shape) {
      if (shapes == shapes_.size()) shapes_.emplace_back();
      transform(map.linear, map.shift, scene.outlined_shape(std::size_t(n.a)), shapes_[shapes]);
      n.a = int(shapes++);
    } else {
      n.a = place[std::size_t(n.a)];
      n.b = n.b < 0 ? n.a : place[std::size_t(n.b)];
      n.amount *= map.scale();
    }
    place[std::size_t(i)] = int(nodes_.size());
    nodes_.push_back(n);
  }
  shapes_.resize(shapes);
  if (!asked_) asked_ = std::make_unique<ShapeDistances>();
  asked_->begin(shapes);
}

double AreaDistance::tree_at(glm::dvec2 p, std::span<const Node> nodes, double* values) const {
  worked(30 * std::int64_t(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    values[i] = n.op == Op::shape ? of_shape(std::size_t(n.a), p)
                                  : combine(n.op, values[n.a], values[n.b], n.amount);
  }
  return values[nodes.size() - 1];
}

double AreaDistance::at(glm::dvec2 p) const {
  if (nodes_.size() == 1) return of_shape(0, p);
  std::array<double, 32> few;
  if (nodes_.size() <= few.size()) return tree_at(p, nodes_, few.data());
  std::vector<double> many(nodes_.size());
  return tree_at(p, nodes_, many.data());
}

void AreaDistance::narrow(glm::dvec2 middle, double radius, std::vector<Node>& to) const {
  constexpr int kUnused = -4, kNeeded = -3, kOnlyA = -2, kOnlyB = -1;
  const std::size_t count = nodes_.size();
  worked(60 * std::int64_t(count));
  const double change = 2.0 * radius + 1e-3;
  std::vector<double> values(count);
  tree_at(middle, nodes_, values.data());
  std::vector<int> place(count, kUnused);
  place[count - 1] = kNeeded;
  for (std::size_t i = count; i-- > 0;) {
    const Node& n = nodes_[i];
    if (place[i] == kUnused || n.op == Op::shape) continue;
    const bool binary = n.op == Op::unite || n.op == Op::intersect || n.op == Op::subtract;
    const double sign = n.op == Op::unite ? -1.0 : 1.0;  // the larger one counts
    const double a = sign * values[std::size_t(n.a)], b = n.op == Op::subtract
                                                              ? -values[std::size_t(n.b)]
                                                              : sign * values[std::size_t(n.b)];
    place[i] = binary && a > b + change ? kOnlyA : binary && b > a + change ? kOnlyB : kNeeded;
    if (place[i] != kOnlyB) place[std::size_t(n.a)] = kNeeded;
    if (binary && place[i] != kOnlyA) place[std::size_t(n.b)] = kNeeded;
  }
  to.clear();
  for (std::size_t i = 0; i < count; ++i) {
    Node n = nodes_[i];
    const int how = place[i];
    if (how == kUnused) continue;
    if (n.op != Op::shape) {
      const int a = place[std::size_t(n.a)], b = place[std::size_t(n.b)];
      const int only = how == kOnlyA ? a : how == kOnlyB ? b : -1;
      if (only >= 0 && !(how == kOnlyB && n.op == Op::subtract)) {
        place[i] = only;
        continue;
      }
      n.a = only >= 0 ? only : a, n.b = only >= 0 ? only : b;
      if (only >= 0) n.op = Op::complement;
    }
    place[i] = int(to.size());
    to.push_back(n);
  }
}

/// It grows as the shape's whose distance it is, or the opposite way.
Outward AreaDistance::outward(glm::dvec2 p, std::span<const Node> nodes) const {
  std::array<double, 32> few;
  std::vector<double> many(nodes.size() <= few.size() ? 0 : nodes.size());
  double* const values = many.empty() ? few.data() : many.data();
  const double d = nodes.size() > 1 ? tree_at(p, nodes, values) : 0.0;
  std::size_t at = nodes.size() - 1;
  double sign = 1.0;
  while (nodes[at].op != Op::shape) {
    const Node& n = nodes[at];
    const double a = values[n.a], b = values[n.b];
    const bool second = (n.op == Op::unite && b < a) || (n.op == Op::intersect && b > a) ||
                        (n.op == Op::subtract && -b > a);
    const bool turns =
        second ? n.op == Op::subtract : n.op == Op::complement || (n.op == Op::shell && a < 0.0);
    if (turns) sign = -sign;
    at = std::size_t(second ? n.b : n.a);
  }
  const auto shape = std::size_t(nodes[at].a);
  const Outward own = asked_->outward(shape, shapes_[shape], p);
  return {nodes.size() > 1 ? d : own.d, sign * own.normal};
}

}  // namespace mien
