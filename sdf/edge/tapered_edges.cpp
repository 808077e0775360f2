// Edges of strokes of varying width. The distance is phi(p) = min over t of g(p, t), g = |p − B(t)|
// − w(t).

#include <mien/sdf/shape/tapered_stroke.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

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
  return {point(s.spine, t), tangent(s.spine, t),
          bend(s.spine),     w[0] + t * (2.0 * a + t * b),
          2.0 * (a + t * b), 2.0 * b};
}

/// Whether every disc of the stroke outside [lo, hi] keeps clear of the disc (c, radius): by
/// halving pieces until a piece's middle is farther than the piece can reach (|B'| and |w'| are
/// largest at a piece's ends).
bool clear_outside(const TaperedStroke& s, double offset, glm::dvec2 c, double radius, double lo,
                   double hi) {
  const auto clear = [&](auto&& self, double t0, double t1, int depth) -> bool {
    if (!(t0 < t1)) return true;
    const At middle = at(s, 0.5 * (t0 + t1)), a = at(s, t0), b = at(s, t1);
    const double gap = glm::length(c - middle.point) - middle.width - offset - radius;
    if (!(gap > 0.0)) return false;
    const double speed = std::max(glm::length(a.velocity), glm::length(b.velocity)) +
                         std::max(std::abs(a.width_rate), std::abs(b.width_rate));
    if (gap > 0.5 * (t1 - t0) * speed) return true;
    return depth > 0 && self(self, t0, 0.5 * (t0 + t1), depth - 1) &&
           self(self, 0.5 * (t0 + t1), t1, depth - 1);
  };
  constexpr int kHalvings = 10;
  return clear(clear, 0.0, std::min(lo, 1.0), kHalvings) &&
         clear(clear, std::max(hi, 0.0), 1.0, kHalvings);
}

/// Whether g_tt > 0 for every p in the disc (c, radius) and every t within `half` of a middle.
///     g_tt = (n'·B')²/rho − n·B'' − w'',   rho = |p − B|, n = (p − B)/rho, n' across it
/// p − B moves by at most `reach`, so n turns by at most turn = reach/(rho − reach); a product with n' then changes by
/// that with n times turn, and its own length times turn²/2.
bool convex_around(const TaperedStroke& s, glm::dvec2 c, double radius, double middle,
                   double half) {
  const At foot = at(s, middle);
  const glm::dvec2 m = c - foot.point;
  const double rho = glm::length(m), speed = glm::length(foot.velocity),
               pull = glm::length(foot.acceleration);
  const double reach = radius + (speed + pull * half) * half, turn = reach / (rho - reach);
  if (!(turn > 0.0 && turn < 1.0)) return false;
  const glm::dvec2 n = m / rho, across{-n.y, n.x};
  const double run = std::abs(glm::dot(across, foot.velocity)),
               rise = std::abs(glm::dot(n, foot.velocity));
  const double least_run =
      std::max(0.0, run - pull * half - rise * turn - 0.5 * speed * turn * turn);
  const double bend = glm::dot(n, foot.acceleration) +
                      std::abs(glm::dot(across, foot.acceleration)) * turn +
                      0.5 * pull * turn * turn;
  return least_run * least_run / (rho + reach) - bend - foot.width_bend > 0.0;
}

/// The envelope of the discs on the side of unit n: E(t) = B + w n with n·B' = −w'. Differentiating
/// that, n turns by omega = −(n·B'' + w'')/q per t, q = n'·B', n' across n and along the run; E
/// moves by v = q + w omega along n'. So the outline bends by omega/v.
struct Envelope {
  double bend;
  double speed;        ///< v
  double slowest;      ///< bound below v for t within `half`
  double bend_change;  ///< bound on |d bend / d arc| for t within `half`, or kUnproven
};

/// With everything bounded over |t − t0| <= half, where n turns by at most theta:
///     omega' = (−omega (n'·B'') q + (n·B'' + w'')(omega w' + n'·B''))/q²,    v' = 2 omega w' + n'·B'' + w omega'.
Envelope envelope(const At& e, double width, glm::dvec2 n, double half) {
  glm::dvec2 across{-n.y, n.x};
  if (glm::dot(across, e.velocity) < 0.0) across = -across;
  const double q = glm::dot(across, e.velocity), pull = glm::length(e.acceleration),
               speed = glm::length(e.velocity);
  const double lag = glm::dot(n, e.acceleration) + e.width_bend, omega = -lag / q,
               v = q + width * omega;
  Envelope result{omega / v, v, 0.0, kUnproven};
  const double theta =
      2.0 * half * std::abs(omega) + 2.0 * half * half * pull * pull / (q * q) + 1e-6;
  const double q_lo = q - pull * half - speed * theta;
  if (!(q > 0.0 && q_lo > 0.5 * q)) return result;
  const double lag_hi = std::abs(lag) + pull * theta, omega_hi = lag_hi / q_lo;
  if (!(omega_hi * half <= theta)) return result;
  const double along_hi = std::abs(glm::dot(across, e.acceleration)) + pull * theta;
  const double rate_hi = std::abs(e.width_rate) + std::abs(e.width_bend) * half;
  const double width_hi = width + rate_hi * half, q_hi = q + pull * half + speed * theta;
  const double omega_change =
      (omega_hi * along_hi * q_hi + lag_hi * (omega_hi * rate_hi + along_hi)) / (q_lo * q_lo);
  const double v_change = 2.0 * omega_hi * rate_hi + along_hi + width_hi * omega_change;
  const double v_lo = v - v_change * half, v_hi = v + v_change * half;
  if (!(v_lo > 0.5 * v)) return result;
  result.slowest = v_lo;
  result.bend_change = (omega_change * v_hi + omega_hi * v_change) / (v_lo * v_lo * v_lo);
  return result;
}

/// A body edge at t, with its error for the disc (c, radius), or kUnproven.
///
/// Proof. On J around t, cut in pieces, g_tt > 0 for every point of the disc: one minimum at most.
/// Outside J the discs keep clear: none. So in the disc the outline is one piece of envelope; with
/// |bend|·radius <= 1/4 its foot moves by at most arc 2·radius, on which `envelope` bounds the
/// change of its bend. Third order and the circle's fourth are what is left.
LevelEdge body_edge(const TaperedStroke& s, double offset, glm::dvec2 c, double radius, double t,
                    double d) {
  const At foot = at(s, t);
  const glm::dvec2 m = c - foot.point;
  const double rho = glm::length(m);
  LevelEdge result{{.d = d, .normal = rho > 0.0 ? m / rho : glm::dvec2{1.0, 0.0}, .bend = 0.0},
                   kUnproven,
                   kUnproven};
  const glm::dvec2 n = result.edge.normal;
  const double run = std::abs(n.x * foot.velocity.y - n.y * foot.velocity.x);
  const double g = run * run / rho - glm::dot(n, foot.acceleration) - foot.width_bend;
  if (!(rho > radius) || !(g > 0.0)) return result;
  // Arc 2·radius of the envelope, at no less than half its speed.
  const double v = envelope(foot, foot.width + offset, n, 0.0).speed;
  if (!(v > 0.0)) return result;
  const Envelope edge = envelope(foot, foot.width + offset, n, 4.0 * radius / v);
  if (!(edge.bend_change < kUnproven) || !(std::abs(edge.bend) * radius <= 0.25)) return result;

  const double stretch = 4.0 * radius / v;
  if (t - stretch < 0.0 || t + stretch > 1.0)
    return result;  // the round end may begin within the disc

  // Where g has grown by 2·radius, by its second derivative at t, with half as much again.
  const double wide = 3.0 * std::sqrt(radius / g) + 4.0 * radius / v;
  const double from = std::max(t - wide, 0.0), to = std::min(t + wide, 1.0);
  constexpr int kPieces = 24;
  const double half = 0.5 * (to - from) / kPieces;
  for (int i = 0; i < kPieces; ++i)
    if (!convex_around(s, c, radius, from + (2 * i + 1) * half, half)) return result;
  if (!clear_outside(s, offset, c, radius, from, to)) return result;

  result.edge.bend = edge.bend;
  const Remainder left = remainder(edge.bend, edge.bend_change, radius);
  result.round_error = left.round, result.error = left.parabola;
  return result;
}

/// The normal of one side's envelope, +1 left of the spine or −1 right of it: it leans against the
/// growth of the width. NaN where neighbouring discs swallow each other.
glm::dvec2 side_normal(const At& e, double side) {
  const double speed = glm::length(e.velocity), lean = e.width_rate / speed;
  const glm::dvec2 tangent = e.velocity / speed, normal{-tangent.y, tangent.x};
  return side * std::sqrt(1.0 - lean * lean) * normal - lean * tangent;
}

/// One side of a stroke too thin to be told from its other side, seen from c: the parameter whose
/// side normal passes through c, by secant steps from t. NaN if there is none near.
double side_foot(const TaperedStroke& s, glm::dvec2 c, double t, double side) {
  const auto off = [&](double x) {
    const At e = at(s, x);
    const glm::dvec2 n = side_normal(e, side), m = c - e.point;
    return (n.x * m.y - n.y * m.x) * side;
  };
  double a = t, b = t + 1e-3, fa = off(a), fb = off(b);
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    if (!(fa != fb)) return fb == 0.0 ? b : std::numeric_limits<double>::quiet_NaN();
    const double next = b - fb * (b - a) / (fb - fa);
    if (!(next > -0.5 && next < 1.5)) return std::numeric_limits<double>::quiet_NaN();
    a = b, fa = fb, b = next, fb = off(b);
    if (std::abs(b - a) < 1e-14) return b;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Both sides of a thin stroke, proven; or nothing.
///
/// Proof. Discs whose t lies outside J, the stretch around the feet by arc 1.5·width + 3·radius each way,
/// keep clear of the disc (c, radius). Over J each side's normal turns by little and its envelope runs
/// forward (`envelope` checks both), so each side is one graph over the tangent at its foot, and what
/// the discs of J cover within the disc is what lies between the two: the stroke's ends are farther
/// than 2·radius along, and their caps lie beyond.
bool both_sides(const TaperedStroke& s, double offset, glm::dvec2 c, double radius, double t,
                AllOf& all) {
  for (const double side : {1.0, -1.0}) {
    const double foot_t = side_foot(s, c, t, side);
    if (!(foot_t > 0.0 && foot_t < 1.0)) return false;
    const At foot = at(s, foot_t);
    const glm::dvec2 n = side_normal(foot, side);
    const double width = foot.width + offset;
    if (!(width > 0.0)) return false;
    const double v = envelope(foot, width, n, 0.0).speed;
    if (!(v > 0.0)) return false;
    // The outline in the disc is within arc 1.5·radius of the foot, at no less than 3/4 of its speed.
    const double stretch = 2.0 * radius / v;
    const double from = std::min(t, foot_t) - stretch, to = std::max(t, foot_t) + stretch;
    if (!(from > 0.0 && to < 1.0)) return false;
    const Envelope edge = envelope(foot, width, n, stretch);
    if (!(edge.bend_change < kUnproven) || !(edge.slowest >= 0.75 * v) ||
        !(std::abs(edge.bend) * radius <= 0.25))
      return false;
    // Discs farther along may overlap the disc from within; what their envelope does there must be
    // known too.
    const double wide = (1.5 * width + 3.0 * radius) / v;
    if (!(envelope(foot, width, n, wide).slowest > 0.0) ||
        !clear_outside(s, offset, c, radius, foot_t - wide, foot_t + wide))
      return false;
    const double r2 = radius * radius, bend = std::abs(edge.bend);
    const double round_error = edge.bend_change * r2 * radius / 6.0;
    all.add({.d = glm::dot(c - foot.point, n) - width, .normal = n, .bend = edge.bend},
            round_error + 0.25 * bend * bend * bend * r2 * r2, round_error);
  }
  return true;
}

/// Both sides of the stroke where it is thin, seen from the spine point nearest to c: the common
/// tangents of neighbouring discs, which lean by the rate at which the width grows.
LocalOutline thin_edges(const TaperedStroke& s, double offset, glm::dvec2 c, double radius,
                        std::vector<Edge>& edges) {
  const CurveFoot foot = foot_near(curve_of(s.spine), c, radius, 0.0);
  {
    AllOf sides(radius, edges);
    const std::size_t before = edges.size();
    if (foot.where == CurveFoot::Where::body && both_sides(s, offset, c, radius, foot.t, sides))
      return sides.outline();
    edges.resize(before);
  }
  const At spine = at(s, foot.t);
  const double width = spine.width + offset, speed = glm::length(spine.velocity);
  const double lean = speed > 0.0 ? spine.width_rate / speed : 2.0;
  if (foot.where != CurveFoot::Where::body || !(std::abs(lean) < 1.0)) {
    LocalOutline outline = disc_edges(foot.point, width, c, radius, edges);
    outline.error = outline.round_error = kUnproven;
    return outline;
  }
  AllOf all(radius, edges);
  const double upright = std::sqrt(1.0 - lean * lean);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec2 normal = side * upright * foot.normal - lean * foot.tangent;
    all.add({.d = glm::dot(c - foot.point, normal) - width, .normal = normal, .bend = 0.0},
            kUnproven);
  }
  LocalOutline outline = all.outline();
  outline.error = outline.round_error = kUnproven;  // out of reach too: another branch may be near
  return outline;
}

/// Whether every point of the disc (c, radius) has the end t = 0 or 1 as its foot, rather than a t
/// within `little` of it: there g must grow inwards. Its slope is −n·B' − w' at the end; over the
/// disc n turns by at most radius/(rho − radius), over `little` the slope falls by at most |B''| +
/// |w''| per t (the rest of g_tt is >= 0).
bool end_alone(const At& end, glm::dvec2 c, double radius, double inward, double little) {
  const glm::dvec2 m = c - end.point;
  const double rho = glm::length(m);
  if (!(rho > 2.0 * radius)) return false;
  const double slope = inward * (-glm::dot(m / rho, end.velocity) - end.width_rate);
  const double slack = glm::length(end.velocity) * radius / (rho - radius) +
                       little * (glm::length(end.acceleration) + std::abs(end.width_bend));
  return slope > slack;
}

/// A zero of g' found from c's nearest of a few spine points, by Newton's steps; or NaN. Far cheaper
/// than the search of all minima, and no less sure where body_edge then proves that it is the only
/// one.
double likely_foot(const TaperedStroke& s, glm::dvec2 c) {
  constexpr int kTries = 8, kSteps = 8;
  double t = 0.5, nearest = kUnproven;
  for (int i = 1; i < kTries; ++i) {
    const double x = double(i) / kTries;
    const At e = at(s, x);
    if (const double g = glm::length(c - e.point) - e.width; g < nearest) nearest = g, t = x;
  }
  for (int step = 0; step < kSteps; ++step) {
    const At e = at(s, t);
    const glm::dvec2 m = c - e.point;
    const double rho = glm::length(m);
    if (!(rho > 0.0)) break;
    const glm::dvec2 n = m / rho;
    const double run = n.x * e.velocity.y - n.y * e.velocity.x;
    const double slope = -glm::dot(n, e.velocity) - e.width_rate;
    const double rise = run * run / rho - glm::dot(n, e.acceleration) - e.width_bend;
    if (!(rise > 0.0)) break;
    const double move = slope / rise;
    t = std::clamp(t - move, 0.0, 1.0);
    if (std::abs(move) < 1e-13) return t;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

LocalOutline tapered_edges(const TaperedStroke& s, double offset, glm::dvec2 c, double radius,
                           std::vector<Edge>& edges) {
  if (const double t = likely_foot(s, c); t > 0.0 && t < 1.0) {
    if (const At foot = at(s, t); foot.width + offset < 12.0 * radius) {
      const CurveFoot spine = foot_near(curve_of(s.spine), c, radius, 0.0);
      AllOf sides(radius, edges);
      const std::size_t before = edges.size();
      if (spine.where == CurveFoot::Where::body && both_sides(s, offset, c, radius, spine.t, sides))
        return sides.outline();
      edges.resize(before);
    }
    const At foot = at(s, t);
    const double d = glm::length(c - foot.point) - foot.width - offset;
    if (d < -radius) return {.rule = EdgeRule::inside};
    if (d > radius && clear_outside(s, offset, c, radius, 2.0, 2.0))
      return {.rule = EdgeRule::outside};
    if (const LevelEdge edge = body_edge(s, offset, c, radius, t, d);
        std::abs(d) <= radius && edge.error < kUnproven) {
      AllOf all(radius, edges);
      all.add(edge.edge, edge.error, edge.round_error);
      return all.outline();
    }
  }
  const NearestDisc near = nearest(s, c);
  const double d = near.distance - offset;
  if (d > radius) return {.rule = EdgeRule::outside};
  if (d < -radius) return {.rule = EdgeRule::inside};
  const At foot = at(s, near.t);
  const bool at_begin = near.t <= 0.0, at_end = near.t >= 1.0;
  if (at_begin || at_end) {
    LocalOutline outline = disc_edges(foot.point, foot.width + offset, c, radius, edges);
    const double little =
        std::min(0.5, 4.0 * radius / std::max(glm::length(foot.velocity), 1e-300));
    const bool alone = end_alone(foot, c, radius, at_begin ? 1.0 : -1.0, little) &&
                       (at_begin ? clear_outside(s, offset, c, radius, -1.0, little)
                                 : clear_outside(s, offset, c, radius, 1.0 - little, 2.0));
    if (!alone) outline.error = outline.round_error = kUnproven;
    return outline;
  }
  const LevelEdge edge = body_edge(s, offset, c, radius, near.t, d);
  if (edge.error == kUnproven && foot.width + offset < 2.0 * radius)
    return thin_edges(s, offset, c, radius, edges);
  AllOf all(radius, edges);
  all.add(edge.edge, edge.error, edge.round_error);
  return all.outline();
}

}  // namespace mien
