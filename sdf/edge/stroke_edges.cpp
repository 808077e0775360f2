// Edges of strokes of constant width: two parallel sides and round ends.

#include <cmath>
#include <glm/geometric.hpp>

#include "edges_private.h"

namespace mien {
namespace {

/// How far a round end and the body next to it differ within the disc: they share point and tangent at
/// the junction, so they part by half the difference of their bends times the square of the way from
/// there, at most the disc's diameter. The body's side bends by at most 2·bend where it is proven at
/// all (a level that takes more than half the radius of curvature is not); a tenth more for the slope.
double junction_error(double half_width, double bend, double radius) {
  if (!(half_width >= 4.0 * radius)) return kUnproven;
  const double diameter = 2.0 * radius;
  return 0.55 * (1.0 / half_width + 2.0 * std::abs(bend)) * diameter * diameter;
}

}  // namespace

LocalOutline line_edges(const Line& line, double half_width, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges) {
  if (!(half_width >= 0.0)) return {};
  const glm::dvec2 ab = line.b - line.a;
  const double length = glm::length(ab);
  if (!(length > 0.0)) return disc_edges(line.a, half_width, c, radius, edges);
  const glm::dvec2 tangent = ab / length, normal{-tangent.y, tangent.x};
  const double along = glm::dot(c - line.a, tangent), side = glm::dot(c - line.a, normal);
  if (along < -radius) return disc_edges(line.a, half_width, c, radius, edges);
  if (along > length + radius) return disc_edges(line.b, half_width, c, radius, edges);
  const bool at_end = along < radius || along > length - radius;
  if (at_end && (along < 0.0 || along > length)) {
    LocalOutline outline = disc_edges(along < 0.0 ? line.a : line.b, half_width, c, radius, edges);
    const double junction = junction_error(half_width, 0.0, radius);
    outline.error += junction, outline.round_error += junction;
    return outline;
  }
  AllOf all(radius, edges);
  const double error = at_end ? junction_error(half_width, 0.0, radius) : 0.0;
  all.add({.d = side - half_width, .normal = normal, .bend = 0.0}, error);
  all.add({.d = -side - half_width, .normal = -normal, .bend = 0.0}, error);
  return all.outline();
}

LocalOutline stroke_edges(const QuadBezier& spine, double half_width, glm::dvec2 c, double radius,
                          std::vector<Edge>& edges) {
  if (!(half_width >= 0.0)) return {};
  CurveFoot foot = foot_near(curve_of(spine), c, radius, half_width);
  double least_error = 0.0;
  if (foot.straddles_end) {
    least_error = junction_error(half_width, foot.bend, radius);
    foot.proven = true;
  }
  if (foot.where != CurveFoot::Where::body) {
    LocalOutline outline = disc_edges(foot.point, half_width, c, radius, edges);
    const double least = foot.proven ? least_error : kUnproven;
    outline.error += least, outline.round_error += least;
    return outline;
  }
  AllOf all(radius, edges);
  for (const double outward : {1.0, -1.0}) {
    const LevelEdge side = level_edge(foot, outward * half_width, outward, radius);
    all.add(side.edge, side.error + least_error, side.round_error + least_error);
  }
  return all.outline();
}

}  // namespace mien
