#include <mien/ellipse_distance.h>
#include "lib/math/bracketed_root.h"
#include "lib/math/norm.h"
#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace mien {
namespace {

/// A direction (cos, sin) of the parameter: the outline's point is (a cos, b sin).
struct Turn {
  double c, s;
};

Turn unit(double c, double s) {
  const double n = norm({c, s});
  return {c / n, s / n};
}

/// a > b > 0, x >= 0, y > 0, all at most about 1. The foot is (a²x/(T + a² − b²), b²y/T) for the
/// only root T > 0 of
///     g(T) = (a x/(T + a² − b²))² + (b y/T)² − 1,
/// which falls and is convex. T itself is the unknown (not T − b²), so a foot beside the long axis
/// keeps its full relative accuracy however small b y is. Bounds from each term alone, halved
/// geometrically until within a factor 2, then Newton from below, which never passes the root.
Turn foot_near(double a, double b, double x, double y) {
  const double gap = (a - b) * (a + b), ax = a * x, by = b * y;
  double lo = std::max(by, ax - gap), hi = norm({ax, by});
  const auto g = [&](double t) {
    const double v1 = ax / (t + gap), v2 = by / t;
    return ValueSlope{(v1 - 1.0) * (v1 + 1.0) + v2 * v2,
                      -2.0 * (v1 * v1 / (t + gap) + v2 * v2 / t)};
  };
  const double v1 = ax / (lo + gap);  // the largest the first term can be
  if (v1 < 1.0) hi = std::min(hi, by / std::sqrt((1.0 - v1) * (1.0 + v1)));
  hi = std::max(hi, lo);
  for (int i = 0; i < 64 && hi > 2.0 * lo; ++i) {
    const double t = std::sqrt(lo) * std::sqrt(hi);
    (g(t).value >= 0.0 ? lo : hi) = t;
  }
  double t = lo;
  for (int i = 0; i < 40; ++i) {
    const ValueSlope at = g(t);
    const double step = -at.value / at.slope;
    t = std::clamp(t + step, lo, hi);
    if (!(step > 0x1p-40 * t)) break;
  }
  return unit(ax / (t + gap), by / t);
}

/// One Newton step on the outline itself: f = (E − p)·E' with E = (a cos, b sin), taken as a small
/// turn.
Turn polished(Turn e, double a, double b, double x, double y) {
  const glm::dvec2 at{a * e.c, b * e.s}, along{-a * e.s, b * e.c}, off{at.x - x, at.y - y};
  const double slope = glm::dot(along, along) - glm::dot(off, at);
  const double turn = -glm::dot(off, along) / slope;
  if (!(std::abs(turn) < 0.25)) return e;
  const Turn next = unit(e.c - turn * e.s, e.s + turn * e.c);
  const glm::dvec2 then{a * next.c - x, b * next.s - y};
  return glm::dot(then, then) <= glm::dot(off, off) ? next : e;
}

struct QuadrantFoot {
  double distance;  ///< signed
  glm::dvec2 on;
};

/// a >= b >= 0, x >= 0, y >= 0, the largest of a, x, y about 1.
QuadrantFoot foot_in_quadrant(double a, double b, double x, double y) {
  if (a == b) {
    const double n = norm({x, y});
    return {n - a, n > 0.0 ? (a / n) * glm::dvec2(x, y) : glm::dvec2(a, 0.0)};
  }
  if (b == 0.0 || (b * y == 0.0 && y > 0.0)) {  // a segment, to any accuracy
    const glm::dvec2 on{std::min(x, a), 0.0};
    return {norm({x - on.x, y}), on};
  }
  Turn e{1.0, 0.0};
  if (y > 0.0) {
    e = polished(polished(foot_near(a, b, x, y), a, b, x, y), a, b, x, y);
  } else if (a * x < (a - b) * (a + b)) {  // between the evolute's cusps on the long axis
    const double c = a * x / ((a - b) * (a + b));
    e = {c, std::sqrt((1.0 - c) * (1.0 + c))};
  }
  const glm::dvec2 on{a * e.c, b * e.s}, normal{b * e.c, a * e.s};
  return {glm::dot(glm::dvec2(x, y) - on, normal) / norm(normal), on};
}

}  // namespace

NearestOnEllipse nearest(const Ellipse& ellipse, glm::dvec2 p) {
  const glm::dvec2 q = p - ellipse.center, axis = ellipse.axis;
  const glm::dvec2 local{glm::dot(q, axis), axis.x * q.y - axis.y * q.x}, far = glm::abs(local);
  const glm::dvec2 r = ellipse.radii;
  const double size = (r.x + r.y) + (far.x + far.y);
  if (!std::isfinite(size)) return {std::numeric_limits<double>::infinity(), p};
  if (size == 0.0) return {0.0, ellipse.center};
  const double k = std::ldexp(1.0, std::clamp(std::ilogb(size), -1000, 1000));
  const bool tall = r.x < r.y;
  QuadrantFoot foot = tall ? foot_in_quadrant(r.y / k, r.x / k, far.y / k, far.x / k)
                           : foot_in_quadrant(r.x / k, r.y / k, far.x / k, far.y / k);
  if (tall) std::swap(foot.on.x, foot.on.y);
  const double x = k * std::copysign(foot.on.x, local.x), y = k * std::copysign(foot.on.y, local.y);
  return {
      k * foot.distance,
      {ellipse.center.x + (x * axis.x - y * axis.y), ellipse.center.y + (x * axis.y + y * axis.x)}};
}

double distance(const Ellipse& ellipse, glm::dvec2 p) {
  return nearest(ellipse, p).distance;
}

}  // namespace mien
