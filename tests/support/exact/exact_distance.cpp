#include "tests/support/exact/exact_distance.h"

#include <algorithm>
#include <cmath>

namespace mien::test {
namespace {

/// Paths of more sides are not asked for hidden ones.
constexpr std::size_t kMostSides = 64;

double combined(const Node& n, double a, double b) {
  switch (n.op) {
    case Op::unite:
      return std::min(a, b);
    case Op::intersect:
      return std::max(a, b);
    case Op::subtract:
      return std::max(a, -b);
    case Op::complement:
      return -a;
    case Op::offset:
      return a - n.amount;
    case Op::shell:
      return std::abs(a) - n.amount;
    case Op::shape:
      break;
  }
  return a;
}

}  // namespace

ExactDistance::ExactDistance(const Scene& scene) : scene_(scene) {
  for (const Shape& shape : scene.shapes()) {
    outlines_.emplace_back();
    const Path* path = std::get_if<Path>(&shape);
    if (!path || path->rule == FillRule::even_odd) continue;
    std::size_t sides = 0;
    for (const Path::Loop& loop : path->loops) sides += loop.sides.size();
    if (sides > kMostSides) continue;
    ExactOutline outline(*path);
    if (outline.hidden().empty() || outline.stretches().empty()) continue;
    outlines_.back() = std::move(outline);
    any_ = true;
  }
}

double ExactDistance::of_shape(int shape, glm::dvec2 p) const {
  const auto& outline = outlines_[std::size_t(shape)];
  return outline ? outline->distance(p) : scene_.shape_distance(std::size_t(shape), p);
}

double ExactDistance::operator()(Area area, glm::dvec2 p) const {
  if (!any_) return scene_.distance(area, p);
  const auto nodes = scene_.nodes();
  const auto [known, is_new] = needed_.try_emplace(area.node);
  if (is_new) {
    std::vector<char> needed(nodes.size(), 0);
    needed[std::size_t(area.node)] = 1;
    for (int i = area.node; i >= 0; --i) {
      const Node& n = nodes[std::size_t(i)];
      if (!needed[std::size_t(i)]) continue;
      known->second.insert(known->second.begin(), i);
      if (n.op == Op::shape) continue;
      needed[std::size_t(n.a)] = 1;
      if (n.b >= 0) needed[std::size_t(n.b)] = 1;
    }
  }
  values_.resize(nodes.size());
  for (const int i : known->second) {
    const Node& n = nodes[std::size_t(i)];
    values_[std::size_t(i)] = n.op == Op::shape ? of_shape(n.a, p)
                                                : combined(n, values_[std::size_t(n.a)],
                                                           values_[std::size_t(std::max(n.b, 0))]);
  }
  return values_[std::size_t(area.node)];
}

}  // namespace mien::test
