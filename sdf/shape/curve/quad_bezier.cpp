#include <mien/quad_bezier_distance.h>
#include "lib/math/norm.h"
#include "lib/math/unit_zeros.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

constexpr double kFarthest = std::numeric_limits<double>::infinity();

/// The curve seen from a point.
struct SeenCurve {
  glm::dvec2 q0, q1, q2;  ///< control points minus p
  glm::dvec2 a, b;        ///< B(t) − p = q0 + t (2a + t b)

  SeenCurve(const QuadBezier& c, glm::dvec2 p)
      : q0(c.p0 - p), q1(c.p1 - p), q2(c.p2 - p), a(c.p1 - c.p0), b((c.p2 - c.p1) - a) {}

  /// Between 1 and 6 times the largest coordinate; NaN if any is.
  double size() const {
    return (std::abs(q0.x) + std::abs(q0.y)) + (std::abs(q1.x) + std::abs(q1.y)) +
           (std::abs(q2.x) + std::abs(q2.y));
  }

  /// B(t) − p by de Casteljau's rule: no intermediate is longer than the longest of q0, q1, q2.
  glm::dvec2 at(double t) const {
    const double s = 1.0 - t;
    return s * (s * q0 + t * q1) + t * (s * q1 + t * q2);
  }

  /// f = (B − p)·(B'/2) and its slope.
  ValueSlope slope(double t) const {
    const glm::dvec2 u = a + t * b, q = q0 + t * (a + u);
    return {glm::dot(q, u), 2.0 * glm::dot(u, u) + glm::dot(q, b)};
  }

  template <Zeros kWanted>
  UnitZeros zeros() const {
    return unit_zeros<kWanted>(glm::dot(b, b), 3.0 * glm::dot(a, b),
                               2.0 * glm::dot(a, a) + glm::dot(q0, b),
                               [this](double t) { return slope(t); });
  }
};

/// Squares and fourth powers of such sizes neither overflow nor vanish.
bool squares_fit(double size) {
  return size > 0x1p-200 && size < 0x1p200;
}

QuadBezier scaled(const QuadBezier& c, double k) {
  return {k * c.p0, k * c.p1, k * c.p2};
}

bool finite(glm::dvec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}
bool finite(const QuadBezier& c) {
  return finite(c.p0) && finite(c.p1) && finite(c.p2);
}

struct Best {
  double squared, t;
};

Best best_of(const SeenCurve& seen) {
  Best best{glm::dot(seen.q0, seen.q0), 0.0};
  const auto consider = [&](double squared, double t) {
    if (squared < best.squared) best = {squared, t};
  };
  consider(glm::dot(seen.q2, seen.q2), 1.0);
  const UnitZeros zeros = seen.zeros<Zeros::rising>();
  for (int i = 0; i < zeros.count; ++i) {
    const glm::dvec2 q = seen.at(zeros.t[i]);
    consider(glm::dot(q, q), zeros.t[i]);
  }
  return best;
}

double power_of_two_near(double size) {
  return std::ldexp(1.0, std::clamp(std::ilogb(size), -1000, 1000));
}

/// For sizes whose powers leave the range of doubles: the curve seen from p, divided by `scale`.
struct Rescued {
  SeenCurve seen;
  double scale;

  Rescued(const QuadBezier& c, glm::dvec2 p) : seen(c, p), scale(1.0) {
    if (seen.size() == 0.0) return;
    const double largest =
        std::max({std::abs(c.p0.x), std::abs(c.p0.y), std::abs(c.p1.x), std::abs(c.p1.y),
                  std::abs(c.p2.x), std::abs(c.p2.y), std::abs(p.x), std::abs(p.y)});
    scale = power_of_two_near(largest);
    seen = SeenCurve(scaled(c, 1.0 / scale), p / scale);
    if (squares_fit(seen.size())) return;
    const glm::dvec2 q0 = c.p0 - p, q1 = c.p1 - p, q2 = c.p2 - p;  // all control points nearly at p
    scale = power_of_two_near(SeenCurve(c, p).size());
    seen = SeenCurve({q0 / scale, q1 / scale, q2 / scale}, {0.0, 0.0});
  }
};

NearestPoint rescued_nearest(const QuadBezier& c, glm::dvec2 p) {
  if (!finite(c) || !finite(p)) return {kFarthest, 0.0, c.p0};
  const Rescued rescued(c, p);
  const Best best = best_of(rescued.seen);
  return {rescued.scale * std::sqrt(best.squared), best.t,
          p + rescued.scale * rescued.seen.at(best.t)};
}

}  // namespace

double distance(const QuadBezier& curve, glm::dvec2 p) {
  const SeenCurve seen(curve, p);
  if (squares_fit(seen.size())) [[likely]]
    return std::sqrt(best_of(seen).squared);
  return rescued_nearest(curve, p).distance;
}

NearestPoint nearest(const QuadBezier& curve, glm::dvec2 p) {
  const SeenCurve seen(curve, p);
  if (!squares_fit(seen.size())) return rescued_nearest(curve, p);
  const Best best = best_of(seen);
  const double t = best.t, s = 1.0 - t;
  const glm::dvec2 on = s * (s * curve.p0 + t * curve.p1) + t * (s * curve.p1 + t * curve.p2);
  return {std::sqrt(best.squared), t, on};
}

CriticalPoints critical_points(const QuadBezier& curve, glm::dvec2 p) {
  SeenCurve seen(curve, p);
  if (!squares_fit(seen.size())) {
    if (!finite(curve) || !finite(p) || seen.size() == 0.0) return {};
    seen = Rescued(curve, p).seen;
  }
  const UnitZeros zeros = seen.zeros<Zeros::all>();
  return {zeros.count, zeros.t};
}

Box2 bounds(const QuadBezier& c) {
  Box2 box = around(around(Box2{}, c.p0), c.p2);
  for (int i : {0, 1}) {
    const double a = c.p1[i] - c.p0[i], b = (c.p2[i] - c.p1[i]) - a;
    if (!(a * (a + b) < 0.0)) continue;  // no turn inside
    const double t = -a / b, s = 1.0 - t;
    const double turn = s * (s * c.p0[i] + t * c.p1[i]) + t * (s * c.p1[i] + t * c.p2[i]);
    const double slack =
        0x1p-51 * std::max(std::abs(c.p0[i]), std::abs(c.p1[i]) + std::abs(c.p2[i]));
    box.lo[i] = std::min(box.lo[i], turn - slack);
    box.hi[i] = std::max(box.hi[i], turn + slack);
  }
  return box;
}

double smallest_curvature_radius(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  const double bb = glm::dot(b, b), cross = std::abs(a.x * b.y - a.y * b.x);
  if (bb == 0.0) return kFarthest;
  const double t = std::clamp(-glm::dot(a, b) / bb, 0.0, 1.0);
  const double speed = norm(a + t * b);  // smallest |B'/2|; radius = 2 speed³ / |a × b|
  if (cross == 0.0) return speed > 0.0 ? kFarthest : 0.0;
  return 2.0 * speed * speed * speed / cross;
}

}  // namespace mien
