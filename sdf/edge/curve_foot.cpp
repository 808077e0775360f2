#include "curve_foot_private.h"

#include <mien/lib/math/cubic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

constexpr double kCosOfOne =
    0.5403;  // a parabola turns by less than 180° in all, so the cosine decides

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// All t where |C(t) − c|² is stationary, in the domain, and the domain's finite ends.
struct Candidates {
  std::array<double, 5> t;
  int count = 0;
  void add(double x) { t[std::size_t(count++)] = x; }
};

Candidates candidates(const QuadCurve& curve, glm::dvec2 c) {
  const glm::dvec2 m = curve.p0 - c;
  Candidates found;
  if (std::isfinite(curve.lo)) found.add(curve.lo);
  if (std::isfinite(curve.hi)) found.add(curve.hi);
  const Roots roots =
      solve_cubic(2.0 * glm::dot(curve.w, curve.w), 3.0 * glm::dot(curve.v, curve.w),
                  glm::dot(curve.v, curve.v) + 2.0 * glm::dot(m, curve.w), glm::dot(m, curve.v));
  for (int i = 0; i < roots.count; ++i)
    if (const double t = roots.x[std::size_t(i)]; t > curve.lo && t < curve.hi) found.add(t);
  return found;
}

/// What the curve does over a stretch of t: the bounds the proof needs.
struct Stretch {
  double slowest;      // min |C'|
  double bend;         // max |curvature|
  double bend_change;  // max |d curvature / d arc|
};

/// With X = C' × C'', constant: curvature = X/|C'|³, its change along the arc = −3 X
/// (C'·C'')/|C'|⁶; |C'|² is a parabola in t and C'·C'' is linear, so both are bounded by their ends
/// and the vertex.
Stretch over(const QuadCurve& curve, double t0, double t1) {
  const glm::dvec2 acceleration = 2.0 * curve.w;
  const double ww = glm::dot(curve.w, curve.w);
  const double vertex = ww > 0.0 ? std::clamp(-0.5 * glm::dot(curve.v, curve.w) / ww, t0, t1) : t0;
  const double slowest = glm::length(curve.velocity(vertex));
  const double turn = std::abs(cross(curve.v, acceleration));
  const double pull = std::max(std::abs(glm::dot(curve.velocity(t0), acceleration)),
                               std::abs(glm::dot(curve.velocity(t1), acceleration)));
  const double s3 = slowest * slowest * slowest;
  return {slowest, turn / s3, 3.0 * turn * pull / (s3 * s3)};
}

}  // namespace

QuadCurve curve_of(const QuadBezier& b) {
  const glm::dvec2 a = b.p1 - b.p0;
  return {b.p0, 2.0 * a, (b.p2 - b.p1) - a, 0.0, 1.0};
}

CurveFoot foot_near(const QuadCurve& curve, glm::dvec2 c, double radius, double level) {
  const Candidates all = candidates(curve, c);
  CurveFoot foot{};
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < all.count; ++i) {
    const glm::dvec2 m = curve.at(all.t[std::size_t(i)]) - c;
    if (const double d2 = glm::dot(m, m); d2 < nearest)
      nearest = d2, foot.t = all.t[std::size_t(i)];
  }
  foot.distance = std::sqrt(nearest);
  foot.point = curve.at(foot.t);
  const glm::dvec2 velocity = curve.velocity(foot.t);
  const double speed = glm::length(velocity);
  foot.tangent = speed > 0.0 ? velocity / speed : glm::dvec2{1.0, 0.0};
  foot.normal = {-foot.tangent.y, foot.tangent.x};
  foot.side = glm::dot(c - foot.point, foot.normal);
  foot.where = foot.t == curve.lo   ? CurveFoot::Where::begin
               : foot.t == curve.hi ? CurveFoot::Where::end
                                    : CurveFoot::Where::body;
  if (!(speed > 0.0)) return foot;  // a cusp or a point: nothing proven
  foot.bend = cross(velocity, 2.0 * curve.w) / (speed * speed * speed);

  // J, taken in t with the speed at the foot; condition 2 sees to it that the speed does not fall
  // far below.
  const double arc = std::sqrt(8.0 * level * radius) + 4.0 * radius;
  const double before = foot.t - 2.0 * arc / speed, after = foot.t + 2.0 * arc / speed;
  const Stretch wide = over(curve, before, after);
  if (!(wide.slowest >= 0.5 * speed)) return foot;
  const glm::dvec2 enter = curve.velocity(before), leave = curve.velocity(after);
  const bool turns_little =
      glm::dot(enter, leave) >= kCosOfOne * glm::length(enter) * glm::length(leave);
  const double farthest = level + radius;
  // The concave side is the one the bend points to; q·bend > 0 only there.
  const double concave = std::copysign(1.0, foot.bend) * foot.side + 2.0 * radius;
  const double q_bend = wide.bend * std::max(concave, radius);
  if (!turns_little || !(q_bend <= 0.5)) return foot;
  // Convexity at every point of J: seen from there, points of the disc lie by at most `bow` farther to
  // the concave side than seen from the foot.
  const double length = std::max(glm::length(enter), glm::length(leave)) * 2.0 * arc / speed;
  const double bow = std::min(0.5 * wide.bend * length * length, length);
  if (!(wide.bend * (std::max(concave - radius, radius) + bow) < 1.0)) return foot;
  const auto is_far = [&](double t) {
    const glm::dvec2 m = curve.at(t) - c;
    return glm::dot(m, m) > farthest * farthest;
  };
  if (before > curve.lo && !is_far(before)) return foot;
  if (after < curve.hi && !is_far(after)) return foot;
  for (int i = 0; i < all.count; ++i) {
    const double t = all.t[std::size_t(i)];
    if ((t < before || t > after) && !is_far(t)) return foot;
  }
  const double feet = 4.0 * radius / speed;  // arc 2·radius, at no less than half the speed
  foot.bend_change = over(curve, foot.t - feet, foot.t + feet).bend_change;
  foot.proven = true;

  // On which side of the normal lines through the ends, if those are near enough to matter.
  const auto straddles = [&](double t, double outward) {
    const glm::dvec2 end_velocity = curve.velocity(t);
    const double along =
        outward * glm::dot(c - curve.at(t), end_velocity) / glm::length(end_velocity);
    return std::abs(along) < radius;
  };
  if ((before <= curve.lo && straddles(curve.lo, -1.0)) ||
      (after >= curve.hi && straddles(curve.hi, 1.0))) {
    foot.proven = false;
    foot.straddles_end = true;
  }
  return foot;
}

}  // namespace mien
