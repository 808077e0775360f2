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

double AreaDistance::tree_at(glm::dvec2 p, double* values) const {
  worked(30 * std::int64_t(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    values[i] = n.op == Op::shape ? of_shape(std::size_t(n.a), p)
                                  : combine(n.op, values[n.a], values[n.b], n.amount);
  }
  return values[nodes_.size() - 1];
}

double AreaDistance::at(glm::dvec2 p) const {
  if (nodes_.size() == 1) return of_shape(0, p);
  std::array<double, 32> few;
  if (nodes_.size() <= few.size()) return tree_at(p, few.data());
  std::vector<double> many(nodes_.size());
  return tree_at(p, many.data());
}

Outward AreaDistance::outward(glm::dvec2 p) const {
  std::array<Outward, 32> few;
  std::vector<Outward> many(nodes_.size() <= few.size() ? 0 : nodes_.size());
  Outward* const made = many.empty() ? few.data() : many.data();
  worked(30 * std::int64_t(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    if (n.op == Op::shape) {
      made[i] = asked_->outward(std::size_t(n.a), shapes_[std::size_t(n.a)], p);
      continue;
    }
    const Outward &a = made[n.a], &b = made[n.b];
    const double d = combine(n.op, a.d, b.d, n.amount);
    // It grows as that of whose distance it is, or the opposite way.
    const bool second = (n.op == Op::unite && b.d < a.d) || (n.op == Op::intersect && b.d > a.d) ||
                        (n.op == Op::subtract && -b.d > a.d);
    const bool turns =
        second ? n.op == Op::subtract : n.op == Op::complement || (n.op == Op::shell && a.d < 0.0);
    const glm::dvec2 normal = second ? b.normal : a.normal;
    made[i] = {d, turns ? -normal : normal};
  }
  return made[nodes_.size() - 1];
}

}  // namespace mien
