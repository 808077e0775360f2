#include "smooth_curve_private.h"

#include <cmath>

namespace mien {

std::vector<QuadBezier> smooth_curve(std::span<const glm::dvec2> points, double twice_axis) {
  const auto mirrored = [&](glm::dvec2 p) { return glm::dvec2{twice_axis - p.x, p.y}; };
  const auto knot = [](glm::dvec2 a, glm::dvec2 b) {
    return std::sqrt(std::hypot(b.x - a.x, b.y - a.y));
  };
  /// Change of place by knot at the middle one of three points.
  const auto tangent = [&](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const double ab = knot(a, b), bc = knot(b, c);
    return (bc / ab * (b - a) + ab / bc * (c - b)) / (ab + bc);
  };
  const auto tangent_at = [&](std::size_t i) {
    const bool first = i == 0, last = i + 1 == points.size();
    const glm::dvec2 here = points[i];
    if (!first && !last) return tangent(points[i - 1], here, points[i + 1]);
    const glm::dvec2 next = first ? points[1] : points[i - 1];
    const double away = first ? 1 : -1;
    if (mirrored(here) == here && next.x != here.x)
      return away * tangent(mirrored(next), here, next);
    return away * (next - here) / knot(here, next);
  };
  std::vector<QuadBezier> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double quarter = 0.25 * knot(points[i], points[i + 1]);
    const glm::dvec2 leave = points[i] + quarter * tangent_at(i);
    const glm::dvec2 arrive = points[i + 1] - quarter * tangent_at(i + 1);
    const glm::dvec2 middle = 0.5 * (leave + arrive);
    pieces.push_back({points[i], leave, middle});
    pieces.push_back({middle, arrive, points[i + 1]});
  }
  return pieces;
}

std::vector<QuadBezier> straight_curve(std::span<const glm::dvec2> points) {
  std::vector<QuadBezier> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    pieces.push_back({points[i], 0.5 * (points[i] + points[i + 1]), points[i + 1]});
  return pieces;
}

}  // namespace mien
