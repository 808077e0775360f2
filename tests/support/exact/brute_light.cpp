#include "tests/support/exact/brute_light.h"

#include "render/blend/transfer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::test {

CountedForm BruteLight::form(int zone, int x, int y,
                             const std::function<bool(glm::dvec2)>& keeps) const {
  constexpr int kRows = 64, kPlaces = 256;
  CountedForm made;
  for (int j = 0; j < kRows; ++j) {
    const float top = float(j) / kRows, middle = (float(j) + 0.5f) / kRows,
                bottom = float(j + 1) / kRows;
    bool was = false;
    for (int i = 0; i <= kPlaces; ++i) {
      const glm::dvec2 p{x + (i + 0.5) / kPlaces, y + (j + 0.5) / kRows};
      const bool in = i < kPlaces &&
                      (!surface_.area() || surface_.zone_of(surface_.outward(p).d) == zone) &&
                      (!keeps || keeps(p));
      const float at = float(i) / kPlaces;
      if (in != was) made.stretches.push_back({at, top, at, middle, at, bottom, in ? 1.0f : -1.0f});
      was = in;
    }
  }
  return made;
}

double BruteLight::middle(int x, int y) const {
  const glm::dvec2 p = glm::dvec2{x + 0.5, y + 0.5} - surface_.center();
  return surface_.area() ? surface_.area()->at(p) : 0.0;
}

LitPart BruteLight::part(int zone, int x, int y, int places,
                         const std::function<bool(glm::dvec2)>& keeps) {
  constexpr double kStep = 1e-5;
  const AreaDistance* area = surface_.area();
  LitPart out;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      // Rows are shifted by multiples of the golden ratio, so no line runs along the places.
      const double u = std::fmod((i + 0.5) / places + j * 0.6180339887498949, 1.0);
      const double v = (j + 0.5) / places;
      const glm::dvec2 p{x + u, y + v};
      Outward outward;
      if (area) {
        const glm::dvec2 q = p - surface_.center();
        outward.d = area->at(q);
        if (surface_.zone_of(outward.d) != zone) continue;
        const glm::dvec2 grows{area->at({q.x + kStep, q.y}) - outward.d,
                               area->at({q.x, q.y + kStep}) - outward.d};
        const double length = glm::length(grows);
        outward.normal = length > 0.0 ? grows / length : glm::dvec2{0.0};
      }
      if (keeps && !keeps(p)) continue;
      out.area += 1.0, out.centroid += p, out.mean += surface_.color(zone, p, outward);
    }
  if (out.area > 0.0) out.centroid /= out.area, out.mean /= out.area;
  out.area /= double(places) * places;
  return out;
}

double levels_apart(const Mix& a, const Mix& b, Blend blend) {
  double worst = 255.0 * std::abs(a.a - b.a);
  const auto encoded = [&](double v, double alpha) {
    const double c = alpha > 0.0 ? std::clamp(v / alpha, 0.0, 1.0) : 0.0;
    return blend == Blend::linear ? srgb_from_linear(c) : c;
  };
  for (int i = 0; i < 3; ++i)
    worst = std::max(
        worst, 255.0 * std::max(a.a, b.a) * std::abs(encoded(a[i], a.a) - encoded(b[i], b.a)));
  return worst;
}

}  // namespace mien::test
