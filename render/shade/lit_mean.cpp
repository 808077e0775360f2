#include <mien/render/shade/lit_mean.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace mien {
namespace {

/// By Gauss's two places each way.
Mix gauss_mean(const LitSurface& surface, int zone, glm::dvec2 middle, double side) {
  const double g = side * 0.28867513459481287;
  Mix sum{0.0};
  for (const glm::dvec2 by : {glm::dvec2{-g, -g}, {g, -g}, {-g, g}, {g, g}})
    sum += 0.25 * surface.color(zone, middle + by, surface.outward(middle + by));
  return sum;
}

double largest(const Mix& m) {
  return std::max({std::abs(m.r), std::abs(m.g), std::abs(m.b), std::abs(m.a)});
}

Mix divided(const LitSurface& surface, int zone, glm::dvec2 middle, double side, const Mix& coarse,
            double tolerance, int depth) {
  const double q = 0.25 * side;
  const std::array<glm::dvec2, 4> middles{middle + glm::dvec2{-q, -q}, middle + glm::dvec2{q, -q},
                                          middle + glm::dvec2{-q, q}, middle + glm::dvec2{q, q}};
  std::array<Mix, 4> parts;
  Mix sum{0.0};
  double apart = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    parts[i] = gauss_mean(surface, zone, middles[i], 0.5 * side);
    sum += 0.25 * parts[i];
    apart = std::max(apart, largest(parts[i] - parts[0]));
  }
  // Where the quarters are alike there is no kink; agreement of the means alone may be chance.
  if (depth == 0 || (largest(sum - coarse) < tolerance && apart < 30.0 * tolerance)) return sum;
  sum = Mix{0.0};
  for (std::size_t i = 0; i < 4; ++i)
    sum +=
        0.25 * divided(surface, zone, middles[i], 0.5 * side, parts[i], 2.0 * tolerance, depth - 1);
  return sum;
}

/// A place of a part, with how much of the part it stands for.
struct Place {
  glm::dvec2 p;
  double weight;
  Mix color;
};

struct Moments {
  double area = 0;
  glm::dvec2 centroid{0.0};
};

Moments moments_of(const std::vector<Place>& places) {
  Moments m;
  for (const Place& place : places) m.area += place.weight, m.centroid += place.weight * place.p;
  if (m.area > 0.0) m.centroid /= m.area;
  return m;
}

/// Takes away what lies beyond a straight line, so that `area` is left and its centroid moves
/// towards `centroid`.
void cut(std::vector<Place>& places, double area, glm::dvec2 centroid, double side) {
  const Moments now = moments_of(places);
  const glm::dvec2 way = now.centroid - centroid;
  const double length = glm::length(way);
  if (now.area <= area || length < 1e-9) return;
  const glm::dvec2 n = way / length;
  const auto left = [&](const Place& place, double at) {
    return std::clamp((at - glm::dot(place.p - centroid, n)) / side + 0.5, 0.0, 1.0);
  };
  double lo = -2.0, hi = 2.0;
  for (int i = 0; i < 40; ++i) {
    const double at = 0.5 * (lo + hi);
    double sum = 0.0;
    for (const Place& place : places) sum += place.weight * left(place, at);
    (sum < area ? lo : hi) = at;
  }
  for (Place& place : places) place.weight *= left(place, hi);
}

/// The mean, put right for the centroid by the slope of the plane nearest to the colours.
Mix leaning_mean(const std::vector<Place>& places, glm::dvec2 centroid) {
  const Moments m = moments_of(places);
  Mix sum{0.0}, by_x{0.0}, by_y{0.0};
  double xx = 1e-6, xy = 0.0, yy = 1e-6;
  for (const Place& place : places) {
    const glm::dvec2 u = place.p - m.centroid;
    sum += place.weight * place.color;
    by_x += place.weight * u.x * place.color, by_y += place.weight * u.y * place.color;
    xx += place.weight * u.x * u.x, xy += place.weight * u.x * u.y, yy += place.weight * u.y * u.y;
  }
  const double whole = xx * yy - xy * xy;
  const glm::dvec2 off = centroid - m.centroid;
  const Mix leans =
      ((yy * off.x - xy * off.y) / whole) * by_x + ((xx * off.y - xy * off.x) / whole) * by_y;
  return sum / m.area + leans;
}

}  // namespace

Mix square_mean(const LitSurface& surface, int zone, glm::dvec2 corner, double side,
                double tolerance) {
  const glm::dvec2 middle = corner + 0.5 * side;
  return divided(surface, zone, middle, side, gauss_mean(surface, zone, middle, side), tolerance,
                 5);
}

Mix part_mean(const LitSurface& surface, int zone, glm::dvec2 corner, double area,
              glm::dvec2 centroid, int places) {
  std::vector<Place> seen;
  const double side = 1.0 / places, weight = side * side;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      const glm::dvec2 p = corner + side * glm::dvec2{i + 0.5, j + 0.5};
      const Outward outward = surface.outward(p);
      if (surface.area() && surface.zone_of(outward.d) != zone) continue;
      seen.push_back({p, weight, surface.color(zone, p, outward)});
    }
  if (seen.empty()) return surface.color(zone, centroid, surface.outward(centroid));
  cut(seen, area, centroid, side);
  const Moments left = moments_of(seen);
  if (!(left.area > 0.0)) return surface.color(zone, centroid, surface.outward(centroid));
  return leaning_mean(seen, centroid);
}

}  // namespace mien
