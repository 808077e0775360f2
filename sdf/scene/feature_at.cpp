#include <mien/feature_at.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sdf/scene/extended_place.h"

namespace mien {
namespace {

constexpr double kUnseen = 0.5 / 255;                                // half a level of 8 bits
constexpr double kBeyond = std::numeric_limits<double>::infinity();  // all stops

/// Where along a gradient the place p is.
struct PlaceOf {
  const Scene& scene;
  glm::dvec2 p;

  double operator()(const LinearGradient& g) const {
    const glm::dvec2 way = g.to - g.from;
    const double length2 = glm::dot(way, way);
    return length2 > 0 ? glm::dot(p - g.from, way) / length2 : kBeyond;
  }
  double operator()(const RadialGradient& g) const {
    if (!(g.radii.x > 0 && g.radii.y > 0)) return kBeyond;
    const glm::dvec2 d = p - g.center, left{-g.axis.y, g.axis.x};
    return std::hypot(glm::dot(d, g.axis) / g.radii.x, glm::dot(d, left) / g.radii.y);
  }
  double operator()(const DistanceGradient& g) const {
    const double width = g.to - g.from, d = scene.distance(g.area, p) - g.from;
    if (width == 0) return d < 0 ? -kBeyond : kBeyond;
    return d / width;
  }
};

double opacity_of(const Gradient& gradient, const Scene& scene, glm::dvec2 p) {
  const auto& stops = gradient.stops;
  const double place = std::visit(PlaceOf{scene, p}, gradient.along);
  const double at = extended_place(gradient.extend, stops.front().at, stops.back().at, place);
  const auto after = std::upper_bound(stops.begin(), stops.end(), at,
                                      [](double t, const Stop& stop) { return t < stop.at; });
  if (after == stops.begin()) return stops.front().color.a;
  if (after == stops.end()) return stops.back().color.a;
  const Stop &a = *std::prev(after), &b = *after;
  return a.color.a + (b.color.a - a.color.a) * (at - a.at) / (b.at - a.at);
}

bool is_light(const Layer& layer) {
  return layer.name.ends_with(kShadowLayer) || layer.name.ends_with(kGlowLayer);
}

}  // namespace

std::string_view feature_of(const Layer& layer) {
  std::string_view name = layer.name;
  for (const std::string_view ending : {kShadowLayer, kGlowLayer, kContourLayer})
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

double opacity_at(const Scene& scene, int layer, glm::dvec2 p) {
  const Layer& asked = scene.layers()[std::size_t(layer)];
  if (!(scene.distance(asked.area, p) <= 0)) return 0;
  double opacity = asked.paint.color.a;
  if (asked.paint.gradient) opacity *= opacity_of(*asked.paint.gradient, scene, p);
  for (int g = asked.group; g >= 0; g = scene.groups()[std::size_t(g)].parent)
    opacity *= scene.groups()[std::size_t(g)].opacity;
  return opacity;
}

int layer_seen_at(const Scene& scene, glm::dvec2 p) {
  for (int layer = int(scene.layers().size()) - 1; layer >= 0; --layer)
    if (!is_light(scene.layers()[std::size_t(layer)]) && opacity_at(scene, layer, p) >= kUnseen)
      return layer;
  return -1;
}

std::string_view feature_at(const Scene& scene, glm::dvec2 p) {
  const int layer = layer_seen_at(scene, p);
  return layer < 0 ? std::string_view() : feature_of(scene.layers()[std::size_t(layer)]);
}

}  // namespace mien
