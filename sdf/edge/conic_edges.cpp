// Edges of parabola sides and ellipses.

#include <mien/sdf/shape/ellipse.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "edges_private.h"

namespace mien {

LocalOutline parabola_edges(const ParabolaSide& s, double offset, glm::dvec2 c, double radius,
                            std::vector<Edge>& edges) {
  // Run so that the inside is on the left: the tangent at the vertex is the axis turned right.
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const QuadCurve curve{s.vertex, {s.axis.y, -s.axis.x}, s.bend * s.axis, -kInf, kInf};
  const CurveFoot foot = foot_near(curve, c, radius, std::abs(offset));
  AllOf all(radius, edges);
  // Grown by offset, the outline moves to the right of the curve; outward is right.
  const LevelEdge edge = level_edge(foot, -offset, -1.0, radius);
  all.add(edge.edge, edge.error, edge.round_error);
  return all.outline();
}

namespace {

/// The edge at the outline point with parameter (cos, sin), in the ellipse's own frame.
Edge edge_at(double a, double b, glm::dvec2 t, glm::dvec2 p) {
  const glm::dvec2 foot{a * t.x, b * t.y};
  const glm::dvec2 normal = glm::normalize(glm::dvec2{b * t.x, a * t.y});
  const double g = a * a * t.y * t.y + b * b * t.x * t.x;  // |d foot / d angle|²
  return {.d = glm::dot(p - foot, normal), .normal = normal, .bend = a * b / (g * std::sqrt(g))};
}

}  // namespace

LocalOutline ellipse_edges(const Ellipse& s, glm::dvec2 c, double radius,
                           std::vector<Edge>& edges) {
  const double a = s.radii.x, b = s.radii.y, small = std::min(a, b), large = std::max(a, b);
  if (!(small > 0.0)) return {};  // no area
  const glm::dvec2 across{-s.axis.y, s.axis.x}, m = c - s.center;
  const glm::dvec2 p{glm::dot(m, s.axis), glm::dot(m, across)};
  const glm::dvec2 nearest_point = nearest(s, c).point - s.center;
  const glm::dvec2 t = glm::normalize(
      glm::dvec2{glm::dot(nearest_point, s.axis) / a, glm::dot(nearest_point, across) / b});
  Edge edge = edge_at(a, b, t, p);

  // Proof. The reach of an ellipse (no two nearest points closer than that to the outline) is its
  // least radius of curvature, small²/large: with at least 4 radii of it, feet lie within arc
  // 2·radius of this one. Over that arc g = |d foot / d angle|² changes by at most |a² − b²|·angle,
  // and the curvature a b g^(−3/2) changes per arc by (3/2) a b |a² − b²| |sin 2 angle| / g³.
  double error = kUnproven, round_error = kUnproven;
  const double difference = std::abs(a * a - b * b), g = a * a * t.y * t.y + b * b * t.x * t.x;
  const double least_g = std::max(small * small, g - difference * 4.0 * radius / small);
  if (small * small >= 4.0 * radius * large) {
    const double change = 1.5 * a * b * difference / (least_g * least_g * least_g);
    const Remainder left = remainder(edge.bend, change, radius);
    round_error = left.round, error = left.parabola;
  }
  const auto turned = [&](Edge e) {
    e.normal = e.normal.x * s.axis + e.normal.y * across;
    return e;
  };
  AllOf all(radius, edges);
  all.add(turned(edge), error, round_error);
  if (error == kUnproven) {  // so thin that the opposite side may be in the disc too
    const glm::dvec2 opposite = a >= b ? glm::dvec2{t.x, -t.y} : glm::dvec2{-t.x, t.y};
    all.add(turned(edge_at(a, b, opposite, p)), kUnproven);
  }
  return all.outline();
}

}  // namespace mien
