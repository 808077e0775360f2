#include "sdf/scene/same_scene.h"
#include "sdf/shape/same_shape.h"

#include <algorithm>
#include <cstring>

namespace mien {
namespace {

/// Of doubles alone.
template <class Numbers>
bool same_bits(const Numbers& a, const Numbers& b) {
  static_assert(std::is_trivially_copyable_v<Numbers> && sizeof(Numbers) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class Numbers>
bool same_list(const std::vector<Numbers>& a, const std::vector<Numbers>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Numbers)) == 0);
}

bool same_place(const LinearGradient& a, const LinearGradient& b) {
  return same_bits(a, b);
}
bool same_place(const RadialGradient& a, const RadialGradient& b) {
  return same_bits(a, b);
}
bool same_place(const DistanceGradient& a, const DistanceGradient& b) {
  return a.area.node == b.area.node && same_bits(a.from, b.from) && same_bits(a.to, b.to);
}

bool same_gradient(const Gradient& a, const Gradient& b) {
  return a.extend == b.extend && a.along.index() == b.along.index() &&
         std::visit(
             [&](const auto& along) {
               return same_place(along, std::get<std::decay_t<decltype(along)>>(b.along));
             },
             a.along) &&
         same_list(a.stops, b.stops);
}

bool same_relief(const Relief& a, const Relief& b) {
  return a.area.node == b.area.node && a.profile == b.profile && same_bits(a.width, b.width) &&
         same_bits(a.height, b.height) && same_bits(a.specular, b.specular) &&
         same_bits(a.shininess, b.shininess) && same_list(a.table, b.table) &&
         same_list(a.domes, b.domes);
}

template <class Shared, class Same>
bool same_shared(const Shared& a, const Shared& b, Same same) {
  return a == b || (a && b && same(*a, *b));
}

bool same_layer(const Layer& a, const Layer& b) {
  return a.area.node == b.area.node && a.group == b.group &&
         same_bits(a.paint.color, b.paint.color) &&
         same_shared(a.paint.gradient, b.paint.gradient, same_gradient) &&
         same_shared(a.paint.relief, b.paint.relief, same_relief);
}

bool same_node(const Node& a, const Node& b) {
  return a.op == b.op && a.a == b.a && a.b == b.b && same_bits(a.amount, b.amount);
}

/// What counts for all layers.
bool same_frame(const Scene& a, const Scene& b) {
  return a.canvas().y_up == b.canvas().y_up && same_bits(a.canvas().box, b.canvas().box) &&
         same_bits(a.background(), b.background()) &&
         std::equal(a.groups().begin(), a.groups().end(), b.groups().begin(), b.groups().end(),
                    [](const Group& g, const Group& h) {
                      return g.parent == h.parent && g.mix == h.mix &&
                             same_bits(g.opacity, h.opacity);
                    }) &&
         same_bits(a.light().direction, b.light().direction) &&
         same_bits(a.light().ambient, b.light().ambient) && a.layers().size() == b.layers().size();
}

}  // namespace

bool same_scene(const Scene& a, const Scene& b) {
  if (&a.background() == &b.background()) return true;  // the same place in memory
  return same_frame(a, b) &&
         std::equal(a.shapes().begin(), a.shapes().end(), b.shapes().begin(), b.shapes().end(),
                    same_shape) &&
         std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(),
                    same_node) &&
         std::equal(a.layers().begin(), a.layers().end(), b.layers().begin(), same_layer);
}

bool InCommon::find(const Scene& a, const Scene& b) {
  if (!same_frame(a, b)) return false;
  a_ = &a, b_ = &b;
  same_.assign(std::min(a.nodes().size(), b.nodes().size()), 0);
  for (std::size_t i = 0; i < same_.size(); ++i) {
    const Node& n = a.nodes()[i];
    const auto same = [&](int operand) { return operand < 0 || same_[std::size_t(operand)]; };
    same_[i] =
        same_node(n, b.nodes()[i]) &&
        (n.op == Op::shape ? same_shape(a.shapes()[std::size_t(n.a)], b.shapes()[std::size_t(n.a)])
                           : same(n.a) && same(n.b));
  }
  return true;
}

bool InCommon::layer(std::size_t i) const {
  const Layer &a = a_->layers()[i], &b = b_->layers()[i];
  const Gradient* gradient = a.paint.gradient.get();
  const Relief* relief = a.paint.relief.get();
  const auto* along = gradient ? std::get_if<DistanceGradient>(&gradient->along) : nullptr;
  return same_layer(a, b) && (!along || area(along->area)) && (!relief || area(relief->area));
}

}  // namespace mien
