#include "sdf/scene/same_scene.h"
#include "lib/base/fingerprint.h"
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

/// Puts data into a fingerprint, number by number.
class Reader {
 public:
  Reader(Fingerprint& to, const std::vector<std::uint64_t>& areas) : to_(to), areas_(areas) {}

  void operator()(const LinearGradient& g) { numbers(g); }
  void operator()(const RadialGradient& g) { numbers(g); }
  void operator()(const DistanceGradient& g) { area(g.area), to_.add(g.from), to_.add(g.to); }
  void operator()(const Gradient& g) {
    to_.add(int(g.along.index())), to_.add(int(g.extend));
    std::visit(*this, g.along);
    list(g.stops);
  }
  void operator()(const Relief& r) {
    area(r.area), to_.add(int(r.profile));
    for (const double v : {r.width, r.height, r.specular, r.shininess}) to_.add(v);
    list(r.table), list(r.domes);
  }
  void operator()(const Paint& p) {
    numbers(p.color);
    to_.add(bool(p.gradient)), to_.add(bool(p.relief));
    if (p.gradient) (*this)(*p.gradient);
    if (p.relief) (*this)(*p.relief);
  }
  void operator()(const Polyline& s) { to_.add(s.half_width), list(s.points); }
  void operator()(const Path& s) {
    to_.add(int(s.rule)), to_.add(int(s.loops.size()));
    for (const Path::Loop& loop : s.loops) list(loop.sides);
  }
  template <class Figure>
  void operator()(const Figure& s) {
    numbers(s);
  }

 private:
  void area(Area a) { to_.add(a.node < 0 ? 0 : areas_[std::size_t(a.node)]); }
  template <class Numbers>
  void numbers(const Numbers& n) {
    static_assert(std::is_trivially_copyable_v<Numbers> && sizeof n % sizeof(double) == 0);
    double all[sizeof n / sizeof(double)];
    std::memcpy(all, &n, sizeof n);
    for (const double v : all) to_.add(v);
  }
  template <class Numbers>
  void list(const std::vector<Numbers>& all) {
    to_.add(int(all.size()));
    for (const Numbers& n : all) numbers(n);
  }

  Fingerprint& to_;
  const std::vector<std::uint64_t>& areas_;
};

}  // namespace

bool same_scene(const Scene& a, const Scene& b) {
  if (&a.background() == &b.background()) return true;  // the same place in memory
  return a.canvas().y_up == b.canvas().y_up && same_bits(a.canvas().box, b.canvas().box) &&
         same_bits(a.background(), b.background()) &&
         std::equal(a.shapes().begin(), a.shapes().end(), b.shapes().begin(), b.shapes().end(),
                    same_shape) &&
         std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(),
                    same_node) &&
         std::equal(a.layers().begin(), a.layers().end(), b.layers().begin(), b.layers().end(),
                    same_layer) &&
         std::equal(a.groups().begin(), a.groups().end(), b.groups().begin(), b.groups().end(),
                    [](const Group& g, const Group& h) {
                      return g.parent == h.parent && g.mix == h.mix &&
                             same_bits(g.opacity, h.opacity);
                    }) &&
         same_bits(a.light().direction, b.light().direction) &&
         same_bits(a.light().ambient, b.light().ambient);
}

int shapes_in_common(const Scene& a, const Scene& b) {
  const std::size_t count = std::min(a.shapes().size(), b.shapes().size());
  int common = 0;
  for (std::size_t i = 0; i < count; ++i) common += same_shape(a.shapes()[i], b.shapes()[i]);
  return common;
}

void PaintFingerprints::make(const Scene& scene, std::uint64_t seed) {
  areas_.clear(), paints_.clear();
  for (const Node& n : scene.nodes()) {
    Fingerprint area(std::uint64_t(n.op) + 1);
    if (n.op == Op::shape) {
      const Shape& shape = scene.shapes()[std::size_t(n.a)];
      area.add(int(shape.index()));
      std::visit(Reader(area, areas_), shape);
    } else {
      area.add(areas_[std::size_t(n.a)]);
      area.add(n.b < 0 ? 0 : areas_[std::size_t(n.b)]);
      area.add(n.amount);
    }
    areas_.push_back(area.value());
  }
  for (const Layer& layer : scene.layers()) {
    Fingerprint paint(seed);
    if (layer.paint.gradient || layer.paint.relief) Reader(paint, areas_)(layer.paint);
    paints_.push_back(paint.value());
  }
  // Layers of one paint are told apart by how many had it before.
  sorted_.clear();
  for (std::size_t i = 0; i < paints_.size(); ++i) {
    if (!scene.layers()[i].paint.gradient && !scene.layers()[i].paint.relief) continue;
    const std::uint64_t plain = paints_[i];
    Fingerprint paint(plain);
    paint.add(int(std::count(sorted_.begin(), sorted_.end(), plain)));
    paints_[i] = paint.value();
    sorted_.push_back(plain);
  }
}

}  // namespace mien
