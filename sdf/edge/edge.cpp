#include <mien/sdf/edge/edge.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "edges_private.h"

namespace mien {

void AllOf::add(const Edge& edge, double error, double round_error) {
  // Beyond reach by more than the bend can bring it back: decided.
  const double reach =
      radius_ + (error < kUnproven ? 0.5 * std::abs(edge.bend) * radius_ * radius_ + error : 0.0);
  if (edge.d > reach) outside_ = true;
  if (std::abs(edge.d) > reach) return;
  edges_.push_back(edge);
  error_ = std::max(error_, error);
  round_error_ = std::max(round_error_, round_error);
}

LocalOutline AllOf::outline() const {
  const int count = int(edges_.size()) - first_;
  if (outside_) {
    edges_.resize(std::size_t(first_));
    return {.rule = EdgeRule::outside};
  }
  if (count == 0) return {.rule = EdgeRule::inside};
  return {.rule = EdgeRule::all,
          .first = first_,
          .count = count,
          .error = error_,
          .round_error = round_error_};
}

/// With |curvature|·radius <= 1/4 all along, the outline is a graph over its tangent: the sine of its
/// slope is at most 1/4 at a lateral distance of `radius`, so the arc there is at most 1.033·radius long.
/// In arc length it leaves the osculating circle by at most change·s³/6; a circle leaves its parabola
/// by at most x⁴/4R³ (docs/derivations/edges.md).
Remainder remainder(double bend, double change, double radius) {
  bend = std::abs(bend);
  if (!((bend + 2.0 * change * radius) * radius <= 0.25)) return {kUnproven, kUnproven};
  const double r3 = radius * radius * radius, round = 0.19 * change * r3;
  return {round, round + 0.25 * bend * bend * bend * r3 * radius};
}

LevelEdge level_edge(const CurveFoot& foot, double level, double outward, double radius) {
  const Edge edge{.d = outward * (foot.side - level), .normal = outward * foot.normal};
  // The offset curve at `level` bends by k/(1 − level·k), changes by k'/(1 − level·k)³ per its own
  // arc.
  const double stretch = 1.0 - level * foot.bend;
  const double least = stretch - std::abs(level) * foot.bend_change * 4.0 * radius;
  LevelEdge result{edge, kUnproven, kUnproven};
  if (stretch > 0.25) result.edge.bend = -outward * foot.bend / stretch;
  if (foot.proven && least > 0.25) {
    const double change = foot.bend_change / (least * least * least);
    const Remainder left = remainder(result.edge.bend, change, radius);
    result.round_error = left.round, result.error = left.parabola;
  }
  return result;
}

LevelEdge circle_edge(glm::dvec2 center, double circle_radius, glm::dvec2 c, double radius) {
  const glm::dvec2 m = c - center;
  const double rho = glm::length(m);
  const Edge edge{.d = rho - circle_radius,
                  .normal = rho > 0.0 ? m / rho : glm::dvec2{1.0, 0.0},
                  .bend = circle_radius > 0.0 ? 1.0 / circle_radius : 0.0};
  // R − sqrt(R² − s²) − s²/2R <= s⁴/4R³ for |s| <= radius <= R/2.
  const double bend3 = edge.bend * edge.bend * edge.bend, r2 = radius * radius;
  return {edge, 2.0 * radius <= circle_radius ? 0.25 * bend3 * r2 * r2 : kUnproven, 0.0};
}

LocalOutline disc_edges(glm::dvec2 center, double disc_radius, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges) {
  if (!(disc_radius > 0.0)) return {};
  AllOf all(radius, edges);
  const LevelEdge circle = circle_edge(center, disc_radius, c, radius);
  all.add(circle.edge, circle.error, circle.round_error);
  return all.outline();
}

LocalOutline distance_edges(const OffsetShape& shape, glm::dvec2 c, double radius,
                            std::vector<Edge>& edges) {
  const double d = distance(shape, c), h = 1e-3 * radius;
  glm::dvec2 g{distance(shape, c + glm::dvec2{h, 0.0}) - distance(shape, c - glm::dvec2{h, 0.0}),
               distance(shape, c + glm::dvec2{0.0, h}) - distance(shape, c - glm::dvec2{0.0, h})};
  const double length = glm::length(g);
  AllOf all(radius, edges);
  all.add({.d = d, .normal = length > 0.0 ? g / length : glm::dvec2{1.0, 0.0}, .bend = 0.0},
          kUnproven);
  return all.outline();
}

namespace {

struct EdgesOf {
  const OffsetShape& whole;
  glm::dvec2 c;
  double radius;
  std::vector<Edge>& edges;

  LocalOutline operator()(const HalfPlane& s) const {
    AllOf all(radius, edges);
    all.add({.d = glm::dot(c, s.normal) - s.offset - whole.offset, .normal = s.normal, .bend = 0.0},
            0.0);
    return all.outline();
  }
  LocalOutline operator()(const ParabolaSide& s) const {
    return parabola_edges(s, whole.offset, c, radius, edges);
  }
  LocalOutline operator()(const Disc& s) const {
    return disc_edges(s.center, s.radius + whole.offset, c, radius, edges);
  }
  LocalOutline operator()(const Ellipse& s) const {
    return whole.offset == 0.0 ? ellipse_edges(s, c, radius, edges)
                               : distance_edges(whole, c, radius, edges);
  }
  LocalOutline operator()(const Line& s) const {
    return line_edges(s, s.half_width + whole.offset, c, radius, edges);
  }
  LocalOutline operator()(const QuadStroke& s) const {
    return stroke_edges(s.spine, s.half_width + whole.offset, c, radius, edges);
  }
  LocalOutline operator()(const TaperedStroke& s) const {
    return tapered_edges(s, whole.offset, c, radius, edges);
  }
  LocalOutline operator()(const Path& s) const {
    return whole.offset == 0.0 ? path_edges(s, c, radius, edges)
                               : distance_edges(whole, c, radius, edges);
  }
  /// Band, cut disc, triangle, polyline: without offset the renderer takes them apart before it
  /// comes here.
  template <class Other>
  LocalOutline operator()(const Other&) const {
    return distance_edges(whole, c, radius, edges);
  }
};

}  // namespace

LocalOutline edges_near(const OffsetShape& shape, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges) {
  return std::visit(EdgesOf{shape, c, radius, edges}, shape.shape);
}

}  // namespace mien
