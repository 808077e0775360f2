#include "tests/support/random/changed_scene.h"

#include <algorithm>
#include <vector>

namespace mien::test {
namespace {

/// Takes a scene apart and puts it together again.
struct Parts {
  Canvas canvas;
  Color ground;
  Light light;
  std::vector<Shape> shapes;
  std::vector<Node> nodes;
  std::vector<Layer> layers;
  std::vector<Group> groups;

  explicit Parts(const Scene& s)
      : canvas(s.canvas()),
        ground(s.background()),
        light(s.light()),
        shapes(s.shapes().begin(), s.shapes().end()),
        nodes(s.nodes().begin(), s.nodes().end()),
        layers(s.layers().begin(), s.layers().end()),
        groups(s.groups().begin(), s.groups().end()) {}

  void enter(SceneBuilder& build, std::vector<int>& open, int group) const {
    std::vector<int> chain;
    for (int g = group; g >= 0; g = groups[std::size_t(g)].parent) chain.push_back(g);
    std::reverse(chain.begin(), chain.end());
    std::size_t same = 0;
    while (same < open.size() && same < chain.size() && open[same] == chain[same]) ++same;
    for (; open.size() > same; open.pop_back()) build.close_group();
    for (; same < chain.size(); ++same) {
      const Group& g = groups[std::size_t(chain[same])];
      build.open_group(g.name, g.opacity, {}, g.mix);
      open.push_back(chain[same]);
    }
  }

  Scene scene() const {
    SceneBuilder build(canvas, ground);
    build.light(light);
    for (const Node& n : nodes) {
      const Area a{n.a}, b{n.b};
      switch (n.op) {
        case Op::shape:
          build.shape(shapes[std::size_t(n.a)]);
          break;
        case Op::unite:
          build.unite(a, b);
          break;
        case Op::intersect:
          build.intersect(a, b);
          break;
        case Op::subtract:
          build.subtract(a, b);
          break;
        case Op::complement:
          build.complement(a);
          break;
        case Op::offset:
          build.offset(a, n.amount);
          break;
        case Op::shell:
          build.shell(a, n.amount);
          break;
      }
    }
    std::vector<int> open;
    for (const Layer& layer : layers) {
      enter(build, open, layer.group);
      build.layer(layer.name, layer.area, layer.paint);
    }
    enter(build, open, -1);
    return std::move(build).finish();
  }
};

void change_paint(Paint& paint, Random& random) {
  const double by = random.between(0.9, 1.0);
  if (paint.gradient && random.chance(0.5)) {
    Gradient g = *paint.gradient;
    const auto k = std::size_t(random.below(int(g.stops.size())));
    g.stops[k].color.g = random.unit();
    paint.gradient = shared(std::move(g));
  } else if (paint.relief) {
    Relief r = *paint.relief;
    (random.chance(0.5) ? r.height : r.specular) *= by;
    paint.relief = shared(std::move(r));
  } else {
    (random.chance(0.3) ? paint.color.a : paint.color.r) *= by;
  }
}

}  // namespace

Scene changed_scene(const Scene& scene, Random& random) {
  Parts p(scene);
  const auto one_of = [&](auto& list) -> auto& {
    return list[std::size_t(random.below(int(list.size())))];
  };
  switch (random.below(12)) {
    case 0:
      p.ground.g = random.unit();
      break;
    case 1:
      if (!p.groups.empty() && random.chance(0.3))
        one_of(p.groups).mix = MixMode(random.below(3));
      else if (!p.groups.empty())
        one_of(p.groups).opacity *= random.between(0.8, 1.0);
      break;
    case 2:
    case 3:
      change_paint(one_of(p.layers).paint, random);
      break;
    case 4:
      if (p.layers.size() > 2)
        p.layers.erase(p.layers.begin() + random.below(int(p.layers.size())));
      break;
    case 5:
      p.layers.push_back(p.layers[std::size_t(random.below(int(p.layers.size())))]);
      break;
    case 6:
      p.light.ambient = random.unit();
      break;
    case 7:
      break;
    default: {
      Shape& shape = one_of(p.shapes);
      shape = transformed(glm::dmat2{1.0}, random.size(-4, -1) * random.direction(), shape);
    }
  }
  return p.scene();
}

Scene mixed_scene(const Scene& scene, std::uint64_t seed) {
  Random random(~seed);
  Parts p(scene);
  if (p.groups.empty()) {
    p.groups.push_back({"group"});
    const int count = int(p.layers.size()), first = random.below(count),
              end = first + 1 + random.below(count - first);
    for (int i = first; i < end; ++i) p.layers[std::size_t(i)].group = 0;
  }
  for (Group& group : p.groups) {
    if (random.chance(0.6)) group.opacity = 1;
    group.mix = random.chance(0.2) ? MixMode::normal : MixMode(1 + random.below(2));
  }
  return p.scene();
}

}  // namespace mien::test
