#include "tests/support/scenes/hostile_scenes.h"

#include "tests/support/random/random.h"

#include <cmath>
#include <functional>

namespace mien::test {
namespace {

constexpr Color kInk{0.1, 0.2, 0.6, 1}, kRed{0.8, 0.1, 0.1, 1};

QuadBezier side(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

using Place = std::function<glm::dvec2(int)>;

Path path_of(int points, FillRule rule, const Place& at) {
  Path path{{Path::Loop{}}, rule};
  std::vector<glm::dvec2> places;
  for (int i = 0; i < points; ++i) places.push_back(at(i));
  for (int i = 0; i < points; ++i)
    path.loops[0].sides.push_back(
        side(places[std::size_t(i)], places[std::size_t((i + 1) % points)]));
  return path;
}

Place on_lattice(Random& r, double jitter) {
  return [&r, jitter](int) {
    const auto one = [&] { return (r.below(17) - 8) / 8.0 + jitter * r.between(-1, 1); };
    const double x = one();
    return glm::dvec2{x, one()};
  };
}

Place on_star(Random& r, int points) {
  return [&r, points](int i) {
    const double turn = 6.283185307179586 * i / points, reach = 0.5 + 0.3 * r.unit();
    return reach * glm::dvec2{std::cos(turn), std::sin(turn)};
  };
}

class Scenes {
 public:
  explicit Scenes(double size) : size_(size) {}

  int count(int whole) const { return std::max(16, int(size_ * whole)); }

  /// A scene of one layer, plain, and in a group cut to a disc.
  void add(const std::string& name, const std::function<Area(SceneBuilder&)>& area,
           const std::function<Paint(Area)>& paint) {
    for (const bool cut : {false, true}) {
      SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
      build.light({.direction = {-0.45, 0.65, 0.85}, .ambient = 0.35});
      if (cut) build.open_group("group", 0.5, build.shape(Disc{{0, 0}, 0.7}));
      const Area made = area(build);
      build.layer(name, made, paint(made));
      if (cut) build.close_group();
      made_.push_back({name + (cut ? ", cut" : ""), std::move(build).finish()});
    }
  }
  void add_path(const std::string& name, Path path, const std::function<Paint(Area)>& paint) {
    add(
        name, [&](SceneBuilder& build) { return build.shape(path); }, paint);
  }
  std::vector<HostileScene> take() { return std::move(made_); }

 private:
  double size_;
  std::vector<HostileScene> made_;
};

Paint plain(Area) {
  return {.color = kInk};
}
Paint relief(Area area) {
  return {.color = kInk,
          .relief = shared({.area = area,
                            .profile = Profile::round,
                            .width = 0.1,
                            .height = 0.05,
                            .specular = 0.3})};
}
Paint along(Area area) {
  return {.color = {1, 1, 1, 1},
          .gradient = shared(
              {.along = DistanceGradient{area, -0.2, 0.0}, .stops = {{0, kInk}, {1, kRed}}})};
}

}  // namespace

std::vector<HostileScene> hostile_scenes(double size) {
  Scenes scenes(size);
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd})
    for (const double jitter : {0.0, 1e-13, 1e-6, 1e-3}) {
      Random r(1);
      scenes.add_path("lattice", path_of(scenes.count(1000), rule, on_lattice(r, jitter)), plain);
    }
  const int many = scenes.count(100'000);
  for (const glm::dvec2 way : {glm::dvec2{1, 0}, {0, 1}, {0.7, 0.7}, {0.3, -0.9}}) {
    Random r(2);
    scenes.add_path("line",
                    path_of(many, FillRule::nonzero,
                            [&](int) {
                              return glm::dvec2{0.1, 0.1} + r.between(-0.8, 0.8) * way;
                            }),
                    plain);
  }
  Random r(3);
  scenes.add_path("circle",
                  path_of(many, FillRule::nonzero,
                          [&](int i) {
                            const double turn = 6.283185307179586 * i / many;
                            return 0.7 * glm::dvec2{std::cos(turn), std::sin(turn)};
                          }),
                  plain);
  for (const bool lit : {true, false}) {
    const std::string name = lit ? "relief" : "gradient";
    const auto paint = [lit](Area area) { return lit ? relief(area) : along(area); };
    const int points = scenes.count(lit ? 300 : 1000), tangled = scenes.count(300);
    scenes.add_path(name + " on a star", path_of(points, FillRule::nonzero, on_star(r, points)),
                    paint);
    scenes.add_path(name + " on a tangle", path_of(tangled, FillRule::nonzero, on_lattice(r, 0.1)),
                    paint);
  }
  const auto strokes = [&](int count, double length) {
    return [&r, count, length](SceneBuilder& build) {
      Area all;
      for (int i = 0; i < count; ++i) {
        const glm::dvec2 at = r.point(-0.9, 0.9), half = 0.5 * length * r.direction();
        const Area one = build.shape(Line{at - half, at + half, 0.01});
        all = all.node < 0 ? one : build.unite(all, one);
      }
      return all;
    };
  };
  scenes.add("strokes", strokes(scenes.count(4000), 1.5), plain);
  scenes.add("gradient on strokes", strokes(scenes.count(300), 0.3), along);
  return scenes.take();
}

}  // namespace mien::test
