// Edges of strokes of varying width. The distance is phi(p) = min over t of g(p, t), g = |p − B(t)| − w(t).

#include <mien/sdf/shape/tapered_stroke.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "edges_private.h"

namespace mien {
namespace {

/// The stroke's polynomials at one t.
struct At {
  glm::dvec2 point, velocity, acceleration;
  double width, width_rate, width_bend;
};

At at(const TaperedStroke& s, double t) {
  const double* w = s.half_width;
  const double a = w[1] - w[0], b = (w[2] - w[1]) - a;
  return {point(s.spine, t), tangent(s.spine, t), bend(s.spine), w[0] + t * (2.0 * a + t * b),
          2.0 * (a + t * b), 2.0 * b};
}

/// Whether every disc of the stroke outside [lo, hi] keeps clear of the disc (c, radius): by halving pieces until a
/// piece's middle is farther than the piece can reach (|B'| and |w'| are largest at a piece's ends).
bool clear_outside(const TaperedStroke& s, double offset, glm::dvec2 c, double radius, double lo, double hi) {
  const auto clear = [&](auto&& self, double t0, double t1, int depth) -> bool {
    if (!(t0 < t1)) return true;
    const At middle = at(s, 0.5 * (t0 + t1)), a = at(s, t0), b = at(s, t1);
    const double gap = glm::length(c - middle.point) - middle.width - offset - radius;
    if (!(gap > 0.0)) return false;
    const double speed = std::max(glm::length(a.velocity), glm::length(b.velocity)) +
                         std::max(std::abs(a.width_rate), std::abs(b.width_rate));
    if (gap > 0.5 * (t1 - t0) * speed) return true;
    return depth > 0 && self(self, t0, 0.5 * (t0 + t1), depth - 1) && self(self, 0.5 * (t0 + t1), t1, depth - 1);
  };
  constexpr int kHalvings = 10;
  return clear(clear, 0.0, std::min(lo, 1.0), kHalvings) && clear(clear, std::max(hi, 0.0), 1.0, kHalvings);
}

/// A body edge at t, with its error for the disc (c, radius), or kUnproven.
///
/// Proof. On the disc and on I = [t − delta, t + delta] interval bounds are put in for
///     g_tt = (|B'|² − (n·B')²)/rho − n·B'' − w'',     k = 1/rho − (n'·B')²/(rho² g_tt),
/// rho = |p − B|, n = (p − B)/rho, n' across it. If g_tt > 0 the minimum on I is unique; it moves by at most
/// |n'·B'|/(rho g_tt) per length, which must keep it within I; k is the curvature of phi's level line through p, so
/// the outline bends within [k_lo, k_hi], and leaves the expansion with the bend at c by at most (k_hi − k_lo) r²/2.
/// Discs outside I must keep clear.
LevelEdge body_edge(const TaperedStroke& s, double offset, glm::dvec2 c, double radius, double t, double d) {
  const At foot = at(s, t);
  const glm::dvec2 m = c - foot.point;
  const double rho = glm::length(m);
  LevelEdge result{{.d = d, .normal = rho > 0.0 ? m / rho : glm::dvec2{1.0, 0.0}, .bend = 0.0}, kUnproven};
  if (!(rho > 4.0 * radius)) return result;
  const glm::dvec2 n = result.edge.normal, across{-n.y, n.x};
  const double speed = glm::length(foot.velocity), pull = glm::length(foot.acceleration);
  const double run = std::abs(glm::dot(across, foot.velocity));
  const double g0 = run * run / rho - glm::dot(n, foot.acceleration) - foot.width_bend;
  if (!(g0 > 0.0)) return result;
  const double delta = 2.0 * radius * run / (rho * g0);
  const double reach = radius + (speed + pull * delta) * delta;  // how far p − B can move
  const double turn = reach / (rho - reach);                     // and n with it, at most
  if (!(turn > 0.0 && turn < 0.5)) return result;
  const double rho_lo = rho - reach, rho_hi = rho + reach;
  const double slack = pull * delta + (speed + pull * delta) * turn;  // of n·B' and n'·B'
  const double run_lo = std::max(0.0, run - slack), run_hi = run + slack;
  const double straight = glm::dot(n, foot.acceleration) + foot.width_bend;
  const double g_lo = run_lo * run_lo / rho_hi - straight - pull * turn;
  const double g_hi = run_hi * run_hi / rho_lo - straight + pull * turn;
  if (!(g_lo > 0.0) || !(radius * run_hi / (rho_lo * g_lo) <= delta)) return result;
  const double k = 1.0 / rho - run * run / (rho * rho * g0);
  const double k_lo = 1.0 / rho_hi - run_hi * run_hi / (rho_lo * rho_lo * g_lo);
  const double k_hi = 1.0 / rho_lo - run_lo * run_lo / (rho_hi * rho_hi * g_hi);
  if (!clear_outside(s, offset, c, radius, t - delta, t + delta)) return result;
  if (!(std::abs(k) * radius < 0.25)) return result;
  result.edge.bend = k / (1.0 - k * d);  // from the level line through c to the outline
  const double change = std::max(k_hi - k, k - k_lo);
  result.error = 0.5 * change * radius * radius + 0.25 * std::abs(k * k * k) * radius * radius * radius * radius;
  return result;
}

/// Both sides of the stroke where it is thin, seen from the spine point nearest to c: the common tangents of
/// neighbouring discs, which lean by the rate at which the width grows.
LocalOutline thin_edges(const TaperedStroke& s, double offset, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges) {
  const CurveFoot foot = foot_near(curve_of(s.spine), c, radius, 0.0);
  const At spine = at(s, foot.t);
  const double width = spine.width + offset, speed = glm::length(spine.velocity);
  const double lean = speed > 0.0 ? spine.width_rate / speed : 2.0;
  if (foot.where != CurveFoot::Where::body || !(std::abs(lean) < 1.0)) {
    LocalOutline outline = disc_edges(foot.point, width, c, radius, edges);
    outline.error = kUnproven;
    return outline;
  }
  AllOf all(radius, edges);
  const double upright = std::sqrt(1.0 - lean * lean);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec2 normal = side * upright * foot.normal - lean * foot.tangent;
    all.add({.d = glm::dot(c - foot.point, normal) - width, .normal = normal, .bend = 0.0}, kUnproven);
  }
  return all.outline();
}

/// Whether every point of the disc (c, radius) has the end t = 0 or 1 as its foot, rather than a t within `little`
/// of it: there g must grow inwards. Its slope is −n·B' − w' at the end; over the disc n turns by at most
/// radius/(rho − radius), over `little` the slope falls by at most |B''| + |w''| per t (the rest of g_tt is >= 0).
bool end_alone(const At& end, glm::dvec2 c, double radius, double inward, double little) {
  const glm::dvec2 m = c - end.point;
  const double rho = glm::length(m);
  if (!(rho > 2.0 * radius)) return false;
  const double slope = inward * (-glm::dot(m / rho, end.velocity) - end.width_rate);
  const double slack = glm::length(end.velocity) * radius / (rho - radius) +
                       little * (glm::length(end.acceleration) + std::abs(end.width_bend));
  return slope > slack;
}

}  // namespace

LocalOutline tapered_edges(const TaperedStroke& s, double offset, glm::dvec2 c, double radius,
                           std::vector<Edge>& edges) {
  const NearestDisc near = nearest(s, c);
  const double d = near.distance - offset;
  if (d > radius) return {.rule = EdgeRule::outside};
  if (d < -radius) return {.rule = EdgeRule::inside};
  const At foot = at(s, near.t);
  const bool at_begin = near.t <= 0.0, at_end = near.t >= 1.0;
  if (at_begin || at_end) {
    LocalOutline outline = disc_edges(foot.point, foot.width + offset, c, radius, edges);
    const double little = std::min(0.5, 4.0 * radius / std::max(glm::length(foot.velocity), 1e-300));
    const bool alone = end_alone(foot, c, radius, at_begin ? 1.0 : -1.0, little) &&
                       (at_begin ? clear_outside(s, offset, c, radius, -1.0, little)
                                 : clear_outside(s, offset, c, radius, 1.0 - little, 2.0));
    if (!alone) outline.error = kUnproven;
    return outline;
  }
  const LevelEdge edge = body_edge(s, offset, c, radius, near.t, d);
  if (edge.error == kUnproven && foot.width + offset < 2.0 * radius) return thin_edges(s, offset, c, radius, edges);
  AllOf all(radius, edges);
  all.add(edge.edge, edge.error);
  return all.outline();
}

}  // namespace mien
