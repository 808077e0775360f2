#include <mien/tapered_stroke.h>
#include "lib/math/norm.h"
#include "lib/math/unit_zeros.h"

#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// Spine and half-width seen from a point, as one curve (B − p, w + L) in a space where the last
/// coordinate counts negatively: P = |q|² − w² is its squared length.
struct SeenStroke {
  glm::dvec2 q0, q1, q2, a, b;  ///< B(t) − p = q0 + t (2a + t b)
  double w0, w1, w2, wa, wb;    ///< w(t) = w0 + t (2wa + t wb)

  SeenStroke(const TaperedStroke& s, glm::dvec2 p, double k)
      : q0(k * s.spine.p0 - k * p),
        q1(k * s.spine.p1 - k * p),
        q2(k * s.spine.p2 - k * p),
        a(k * s.spine.p1 - k * s.spine.p0),
        b((k * s.spine.p2 - k * s.spine.p1) - a),
        w0(k * s.half_width[0]),
        w1(k * s.half_width[1]),
        w2(k * s.half_width[2]),
        wa(w1 - w0),
        wb((w2 - w1) - wa) {}

  double size() const {
    return (std::abs(q0.x) + std::abs(q0.y)) + (std::abs(q1.x) + std::abs(q1.y)) +
           (std::abs(q2.x) + std::abs(q2.y)) + (std::abs(w0) + std::abs(w1) + std::abs(w2));
  }

  /// |p − B(t)| − w(t).
  double depth(double t) const {
    const double s = 1.0 - t;
    const glm::dvec2 q = s * (s * q0 + t * q1) + t * (s * q1 + t * q2);
    return norm(q) - (s * (s * w0 + t * w1) + t * (s * w1 + t * w2));
  }

  /// Where |q|² − weight·(w + level)² has its minima, weight 0 or 1.
  UnitZeros minima(double weight, double level) const {
    const double va = weight * wa, vb = weight * wb, v0 = weight * (w0 + level);
    return unit_zeros<Zeros::rising>(
        glm::dot(b, b) - vb * vb, 3.0 * (glm::dot(a, b) - va * vb),
        2.0 * (glm::dot(a, a) - va * va) + (glm::dot(q0, b) - v0 * vb), [&](double t) {
          const glm::dvec2 u = a + t * b, q = q0 + t * (a + u);
          const double vu = va + t * vb, v = v0 + t * (va + vu);
          return ValueSlope{glm::dot(q, u) - v * vu,
                            2.0 * (glm::dot(u, u) - vu * vu) + (glm::dot(q, b) - v * vb)};
        });
  }
};

NearestDisc search(const SeenStroke& seen) {
  NearestDisc best{seen.depth(0.0), 0.0};
  const auto consider = [&](double t) {
    const double d = seen.depth(t);
    if (d < best.distance) best = {d, t};
  };
  consider(1.0);
  UnitZeros at = seen.minima(0.0, 0.0);
  for (int i = 0; i < at.count; ++i) consider(at.t[i]);
  if (seen.wa == 0.0 && seen.wb == 0.0) return best;
  const double settled = 0x1p-55 * seen.size();
  for (int step = 0; step < TaperedStrokeContract::kMaxSteps; ++step) {
    const double before = best.distance;
    at = seen.minima(1.0, before);
    for (int i = 0; i < at.count; ++i) consider(at.t[i]);
    if (!(best.distance < before - settled)) break;
  }
  return best;
}

}  // namespace

NearestDisc nearest(const TaperedStroke& stroke, glm::dvec2 p) {
  const SeenStroke seen(stroke, p, 1.0);
  const double size = seen.size();
  if (size > 0x1p-200 && size < 0x1p200) [[likely]]
    return search(seen);
  const double* w = stroke.half_width;
  double largest = 0.0;
  for (const double v : {stroke.spine.p0.x, stroke.spine.p0.y, stroke.spine.p1.x, stroke.spine.p1.y,
                         stroke.spine.p2.x, stroke.spine.p2.y, p.x, p.y, w[0], w[1], w[2]}) {
    if (!std::isfinite(v)) return {std::numeric_limits<double>::infinity(), 0.0};
    largest = std::max(largest, std::abs(v));
  }
  if (size == 0.0) return {0.0, 0.0};
  // Powers of such sizes leave the range of doubles: ask at a safe size.
  const double k = std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
  const NearestDisc n = search(SeenStroke(stroke, p, k));
  return {n.distance / k, n.t};
}

double distance(const TaperedStroke& s, glm::dvec2 p) {
  return nearest(s, p).distance;
}

}  // namespace mien
