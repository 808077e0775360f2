#include <mien/parabola_side.h>
#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// A point beside the parabola v = bend u², bend >= 0, in units of `unit`, a power of two.
struct Beside {
  double u, v, bend, unit;

  /// The foot's cubic divided by `by`² = max(1, bend)², which keeps every size in range:
  /// cube s³ + line s = u / by².
  double by() const { return std::max(1.0, bend); }
  double cube() const { return 2.0 * (bend / by()) * (bend / by()); }
  double line() const { return 1.0 / by() / by() - 2.0 * (bend / by()) * (v / by()); }
};

/// Beyond this bend (times the distance from the vertex) a parabola is a ray to any accuracy.
constexpr double kRay = 0x1p400;
/// Below this it is a straight line: the slope's square is nothing beside 1.
constexpr double kStraight = 0x1p-100;

Beside beside(double u, double v, double bend) {
  const double size = std::max(std::abs(u), std::abs(v));
  const double unit = std::ldexp(1.0, std::clamp(std::ilogb(size), -1000, 1000));
  return {u / unit, v / unit, std::min(bend * unit, kRay), unit};
}

/// The root s >= 0 for u >= 0.
double foot(const Beside& p) {
  const double by = p.by(), cube = p.cube(), line = p.line(), right = p.u / by / by;
  const double ratio = p.bend / by;
  double s = std::cbrt(right / cube);  // a bound above the root, if line >= 0
  if (line > 0.0) s = std::min(s, right / line);
  if (line < 0.0) s = std::sqrt(-line / cube) + std::min(s, right / (-2.0 * line));
  for (int i = 0; i < 100; ++i) {
    const double off = p.bend * s * s - p.v;
    const double value = (s - p.u) / by / by + 2.0 * ratio * s * (off / by);
    const double slope = 1.0 / by / by + 2.0 * ratio * ((2.0 * p.bend * s * s + off) / by);
    if (!(slope > 0.0)) break;
    const double step = value / slope;
    s = std::max(0.0, s - step);
    if (std::abs(step) <= 0x1p-30 * s) break;
  }
  return s;
}

struct Signed {
  double distance, u;
};

/// u, bend >= 0.
Signed nearest_in_frame(double u, double v, double bend) {
  if (u == 0.0 && v == 0.0) return {0.0, 0.0};
  const Beside p = beside(u, v, bend);
  if (p.bend < kStraight) return {p.unit * (p.bend * p.u * p.u - p.v), u};
  const double s = foot(p), slope = 2.0 * p.bend * s;
  // Across the tangent (1, slope), scaled to stay in range.
  const double along = s - p.u, off = p.bend * s * s - p.v;
  const double stretch = std::max(1.0, slope), t0 = 1.0 / stretch, t1 = slope / stretch;
  const double across = (t0 * off - t1 * along) / std::sqrt(t0 * t0 + t1 * t1);
  return {p.unit * across, p.unit * s};
}

struct Frame {
  double u, v;
};

Frame in_frame(const ParabolaSide& side, glm::dvec2 p) {
  const glm::dvec2 q = p - side.vertex;
  return {side.axis.x * q.y - side.axis.y * q.x, glm::dot(q, side.axis)};
}

Signed nearest_signed(const ParabolaSide& side, glm::dvec2 p) {
  const Frame q = in_frame(side, p);
  if (!std::isfinite(q.u) || !std::isfinite(q.v))
    return {std::numeric_limits<double>::infinity(), 0.0};
  Signed n =
      nearest_in_frame(std::abs(q.u), std::signbit(side.bend) ? -q.v : q.v, std::abs(side.bend));
  if (std::signbit(side.bend)) n.distance = -n.distance;
  if (q.u < 0.0) n.u = -n.u;
  return n;
}

}  // namespace

double distance(const ParabolaSide& side, glm::dvec2 p) {
  return outside_if_nan(nearest_signed(side, p).distance);
}

glm::dvec2 point(const ParabolaSide& side, double u) {
  const double v = side.bend * u * u;
  return {side.vertex.x + (v * side.axis.x - u * side.axis.y),
          side.vertex.y + (v * side.axis.y + u * side.axis.x)};
}

NearestOnParabola nearest(const ParabolaSide& side, glm::dvec2 p) {
  const Signed n = nearest_signed(side, p);
  return {outside_if_nan(n.distance), n.u, point(side, n.u)};
}

Roots feet(const ParabolaSide& side, glm::dvec2 p) {
  Frame q = in_frame(side, p);
  if (!std::isfinite(q.u) || !std::isfinite(q.v)) return {};
  if (q.u == 0.0 && q.v == 0.0) return {1, {0.0}};
  if (std::signbit(side.bend)) q.v = -q.v;
  const Beside b = beside(std::abs(q.u), q.v, std::abs(side.bend));
  Roots roots = solve_cubic(b.cube(), 0.0, b.line(), -(b.u / b.by() / b.by()));
  for (int i = 0; i < roots.count; ++i) roots.x[i] *= q.u < 0.0 ? -b.unit : b.unit;
  if (q.u < 0.0) std::reverse(roots.x.begin(), roots.x.begin() + roots.count);
  return roots;
}

}  // namespace mien
