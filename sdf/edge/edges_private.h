#pragma once
// The edges of each kind of outline; edges_near picks among them.

#include <mien/sdf/edge/edge.h>

#include "curve_foot_private.h"

namespace mien {

/// Appends an edge that crosses the disc; remembers what the rule needs otherwise. Collects an area
/// that is the intersection of its edges.
class AllOf {
 public:
  AllOf(double radius, std::vector<Edge>& edges)
      : radius_(radius), edges_(edges), first_(int(edges.size())) {}

  /// error: see LocalOutline. An edge out of reach counts as decided, if its place is proven.
  void add(const Edge& edge, double error, double round_error);
  void add(const Edge& edge, double error) { add(edge, error, error); }
  LocalOutline outline() const;

 private:
  double radius_;
  std::vector<Edge>& edges_;
  int first_;
  bool outside_ = false;
  double error_ = 0, round_error_ = 0;
};

/// The edge at `level` from a spine: the offset curve on the foot's normal side (level > 0) or
/// beyond it (< 0); outward says which way is out: +1 along the foot's normal.
struct LevelEdge {
  Edge edge;
  double error;        ///< as parabola: see LocalOutline
  double round_error;  ///< as circle
};
LevelEdge level_edge(const CurveFoot& foot, double level, double outward, double radius);

/// How far an outline may leave its expansion at a foot within a disc: as circle and as parabola.
struct Remainder {
  double round, parabola;  ///< kUnproven where it bends by more than a quarter of 1/radius
};
/// bend: its curvature at the foot; change: a bound on |d curvature / d arc| over arc 2·radius.
Remainder remainder(double bend, double change, double radius);

/// One edge of a circle around `center`, seen from c.
LevelEdge circle_edge(glm::dvec2 center, double circle_radius, glm::dvec2 c, double radius);

LocalOutline disc_edges(glm::dvec2 center, double disc_radius, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges);
LocalOutline line_edges(const Line& line, double half_width, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges);
LocalOutline stroke_edges(const QuadBezier& spine, double half_width, glm::dvec2 c, double radius,
                          std::vector<Edge>& edges);
LocalOutline parabola_edges(const ParabolaSide& side, double offset, glm::dvec2 c, double radius,
                            std::vector<Edge>& edges);
LocalOutline ellipse_edges(const Ellipse& ellipse, glm::dvec2 c, double radius,
                           std::vector<Edge>& edges);
LocalOutline tapered_edges(const TaperedStroke& stroke, double offset, glm::dvec2 c, double radius,
                           std::vector<Edge>& edges);
LocalOutline path_edges(const Path& path, glm::dvec2 c, double radius, std::vector<Edge>& edges);

/// Any shape, by its distance alone: one edge through the nearest outline point, unproven.
LocalOutline distance_edges(const OffsetShape& shape, glm::dvec2 c, double radius,
                            std::vector<Edge>& edges);

}  // namespace mien
