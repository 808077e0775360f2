#include <mien/render/shade/area_distance.h>

#include <mien/sdf/csg/combine.h>

#include <array>

namespace mien {

AreaDistance::AreaDistance(const Scene& scene, Area area, const Map<PixelSpace, FaceSpace>& map) {
  std::vector<int> place(std::size_t(area.node) + 1, -1);
  std::vector<char> needed(std::size_t(area.node) + 1, 0);
  needed[std::size_t(area.node)] = 1;
  for (int i = area.node; i >= 0; --i) {
    const Node& n = scene.nodes()[std::size_t(i)];
    if (!needed[std::size_t(i)] || n.op == Op::shape) continue;
    needed[std::size_t(n.a)] = 1;
    if (n.b >= 0) needed[std::size_t(n.b)] = 1;
  }
  for (int i = 0; i <= area.node; ++i) {
    if (!needed[std::size_t(i)]) continue;
    Node n = scene.nodes()[std::size_t(i)];
    if (n.op == Op::shape) {
      shapes_.push_back(transformed(map, scene.shapes()[std::size_t(n.a)]));
      n.a = int(shapes_.size()) - 1;
    } else {
      n.a = place[std::size_t(n.a)];
      n.b = n.b < 0 ? n.a : place[std::size_t(n.b)];
      n.amount *= map.scale();
    }
    place[std::size_t(i)] = int(nodes_.size());
    nodes_.push_back(n);
  }
}

double AreaDistance::tree_at(glm::dvec2 p, double* values) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    values[i] = n.op == Op::shape ? distance(shapes_[std::size_t(n.a)], p)
                                  : combine(n.op, values[n.a], values[n.b], n.amount);
  }
  return values[nodes_.size() - 1];
}

double AreaDistance::at(glm::dvec2 p) const {
  if (nodes_.size() == 1) return distance(shapes_[0], p);
  std::array<double, 32> few;
  if (nodes_.size() <= few.size()) return tree_at(p, few.data());
  std::vector<double> many(nodes_.size());
  return tree_at(p, many.data());
}

}  // namespace mien
