#include <mien/scene_effects.h>

#include <algorithm>
#include <utility>

namespace mien {
namespace {

/// A layer of one colour whose opacity falls by soft_edge between two distances.
void add_falling(SceneBuilder& build, std::string name, Area area, Color color, double from,
                 double to) {
  constexpr int kSteps = 16;
  Gradient gradient{.along = DistanceGradient{area, from, to}, .stops = {}};
  for (int i = 0; i <= kSteps; ++i) {
    const double u = double(i) / kSteps;
    gradient.stops.push_back({u, {color.r, color.g, color.b, soft_edge(u)}});
  }
  build.layer(std::move(name), build.everywhere(),
              {.color = {0, 0, 0, color.a}, .gradient = shared(std::move(gradient))});
}

}  // namespace

double soft_edge(double u) {
  const double v = std::clamp(u, 0.0, 1.0);
  return 1.0 - v * v * (3.0 - 2.0 * v);
}

Area contour(SceneBuilder& build, Area area, double half_width) {
  return build.shell(area, half_width);
}

void glow(SceneBuilder& build, std::string name, Area area, const Glow& glow) {
  add_falling(build, std::move(name), area, glow.color, 0.0, glow.reach);
}

void soft_shadow(SceneBuilder& build, std::string name, Area area, const SoftShadow& shadow) {
  const Area there = shadow.shift == glm::dvec2{0.0} ? area : build.moved(area, shadow.shift);
  add_falling(build, std::move(name), there, shadow.color, -shadow.blur, shadow.blur);
}

}  // namespace mien
