#include <mien/scene_effects.h>

#include <algorithm>
#include <utility>

namespace mien {

Paint falling(Area area, Color color, double from, double to) {
  constexpr int kSteps = 16;
  Gradient gradient{.along = DistanceGradient{area, from, to}, .stops = {}};
  for (int i = 0; i <= kSteps; ++i) {
    const double u = double(i) / kSteps;
    gradient.stops.push_back({u, {color.r, color.g, color.b, soft_edge(u)}});
  }
  return {.color = {0, 0, 0, color.a}, .gradient = shared(std::move(gradient))};
}

double soft_edge(double u) {
  const double v = std::clamp(u, 0.0, 1.0);
  return 1.0 - v * v * (3.0 - 2.0 * v);
}

Area contour(SceneBuilder& build, Area area, double half_width) {
  return build.shell(area, half_width);
}

Area pen_contour(SceneBuilder& build, Area area, double thin, double thick, glm::dvec2 toward) {
  const Area hole = build.moved(build.offset(area, -thick), (thin - thick) * toward);
  return build.subtract(build.offset(area, thin), hole);
}

void glow(SceneBuilder& build, std::string name, Area area, const Glow& glow) {
  const Paint paint = falling(area, glow.color, 0.0, glow.reach);
  build.layer(std::move(name), build.everywhere(), paint);
}

void soft_shadow(SceneBuilder& build, std::string name, Area area, const SoftShadow& shadow) {
  const Area there = shadow.shift == glm::dvec2{0.0} ? area : build.moved(area, shadow.shift);
  const Paint paint = falling(there, shadow.color, -shadow.blur, shadow.blur);
  build.layer(std::move(name), shadow.on.node < 0 ? build.everywhere() : shadow.on, paint);
}

}  // namespace mien
