#include "bench/whole/flat_scene.h"

#include <utility>
#include <vector>

namespace mien::bench {
namespace {

Area copied(SceneBuilder& to, const Scene& from, const Node& node, const std::vector<Area>& made) {
  if (node.op == Op::shape) return to.shape(from.shapes()[std::size_t(node.a)]);
  const Area a = made[std::size_t(node.a)], b = node.b < 0 ? a : made[std::size_t(node.b)];
  switch (node.op) {
    case Op::unite:
      return to.unite(a, b);
    case Op::intersect:
      return to.intersect(a, b);
    case Op::subtract:
      return to.subtract(a, b);
    case Op::complement:
      return to.complement(a);
    case Op::offset:
      return to.offset(a, node.amount);
    default:
      return to.shell(a, node.amount);
  }
}

/// The groups that `group` is in, outermost first, itself last.
std::vector<int> chain_of(const Scene& scene, int group) {
  std::vector<int> chain;
  for (; group >= 0; group = scene.groups()[std::size_t(group)].parent)
    chain.insert(chain.begin(), group);
  return chain;
}

}  // namespace

Scene without_reliefs(const Scene& scene) {
  SceneBuilder build(scene.canvas(), scene.background());
  build.light(scene.light());
  // Nodes are added in their order, so every handle stays what it was; gradients may name areas.
  std::vector<Area> made;
  for (const Node& node : scene.nodes()) made.push_back(copied(build, scene, node, made));
  std::vector<int> open;
  for (const Layer& layer : scene.layers()) {
    const std::vector<int> chain = chain_of(scene, layer.group);
    std::size_t common = 0;
    while (common < open.size() && common < chain.size() && open[common] == chain[common]) ++common;
    for (; open.size() > common; open.pop_back()) build.close_group();
    for (; open.size() < chain.size(); open.push_back(chain[open.size()])) {
      const Group& group = scene.groups()[std::size_t(chain[open.size()])];
      build.open_group(group.name, group.opacity, {}, group.mix);
    }
    Paint paint = layer.paint;
    paint.relief = nullptr;
    build.layer(layer.name, made[std::size_t(layer.area.node)], std::move(paint));
  }
  for (; !open.empty(); open.pop_back()) build.close_group();
  return std::move(build).finish();
}

}  // namespace mien::bench
