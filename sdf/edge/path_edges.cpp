// Edges of closed paths: one per side that comes near, and the winding number beyond all of them.

#include <mien/sdf/shape/path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "edges_private.h"

namespace mien {
namespace {

/// A box around the control points keeps the disc away.
bool far_away(const QuadBezier& s, glm::dvec2 c, double radius) {
  const glm::dvec2 lo = glm::min(glm::min(s.p0, s.p1), s.p2),
                   hi = glm::max(glm::max(s.p0, s.p1), s.p2);
  return c.x < lo.x - radius || c.x > hi.x + radius || c.y < lo.y - radius || c.y > hi.y + radius;
}

/// A point next to c that no edge passes close by: where the winding number is counted, so that the
/// count and the edges' sides can't contradict each other by a rounding.
glm::dvec2 counting_point(glm::dvec2 c, double radius, std::span<const Edge> edges) {
  constexpr std::array<glm::dvec2, 5> kTries{
      {{0.0, 0.0}, {0.003, 0.007}, {-0.007, 0.003}, {0.005, -0.009}, {-0.011, -0.002}}};
  glm::dvec2 best = c;
  double widest = -1.0;
  for (const glm::dvec2 step : kTries) {
    double gap = radius;
    for (const Edge& e : edges)
      gap = std::min(gap, std::abs(e.d + radius * glm::dot(step, e.normal)));
    if (gap > widest) widest = gap, best = c + radius * step;
  }
  return best;
}

}  // namespace

LocalOutline path_edges(const Path& path, glm::dvec2 c, double radius, std::vector<Edge>& edges) {
  const int first = int(edges.size());
  double error = 0.0, round_error = 0.0;
  for (const Path::Loop& loop : path.loops)
    for (const QuadBezier& side : loop.sides) {
      if (far_away(side, c, radius)) continue;
      const CurveFoot foot = foot_near(curve_of(side), c, radius, 0.0);
      if (foot.distance > radius) continue;
      // The left of a side is one winding number above its right: out is right.
      const LevelEdge edge = level_edge(foot, 0.0, -1.0, radius);
      if (foot.where != CurveFoot::Where::body || foot.straddles_end)
        error = round_error = kUnproven;
      edges.push_back(edge.edge);
      error = std::max(error, edge.error);
      round_error = std::max(round_error, edge.round_error);
    }
  const int count = int(edges.size()) - first;
  const std::span<const Edge> near{edges.data() + first, std::size_t(count)};
  const glm::dvec2 from = counting_point(c, radius, near);
  int outside = winding(path, from);
  for (const Edge& e : near) outside -= e.d + glm::dot(from - c, e.normal) < 0.0 ? e.turn : 0;
  if (count == 0) {
    return {.rule = is_inside(path.rule, outside) ? EdgeRule::inside : EdgeRule::outside};
  }
  return {.rule = path.rule == FillRule::nonzero ? EdgeRule::nonzero : EdgeRule::even_odd,
          .first = first,
          .count = count,
          .winding = outside,
          .error = error,
          .round_error = round_error};
}

}  // namespace mien
