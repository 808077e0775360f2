#pragma once
// A stroke as a pen that moves: discs of half-width w(t) about B(t), and the two rims they sweep.

#include <mien/box2.h>
#include <mien/quad_bezier.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace mien {

/// B(t) = p + t (2a + t b), w(t) = w + t (2wa + t wb), t in [0, 1].
struct Pen {
  glm::dvec2 p, a, b;
  double w, wa, wb;

  Pen() = default;
  Pen(const QuadBezier& spine, double w0, double w1, double w2)
      : p(spine.p0), a(spine.p1 - spine.p0), b((spine.p2 - spine.p1) - a), w(w0), wa(w1 - w0) {
    wb = (w2 - w1) - wa;
  }

  glm::dvec2 center(double t) const { return p + t * (2.0 * a + t * b); }
  glm::dvec2 velocity(double t) const { return 2.0 * (a + t * b); }
  double width(double t) const { return w + t * (2.0 * wa + t * wb); }
  double rate(double t) const { return 2.0 * (wa + t * wb); }
  /// The largest of w's control values: no w(t) is larger.
  double widest() const { return std::max({w, w + wa, w + 2.0 * wa + wb}); }

  /// The pen's movement from t0 to t1, which may be smaller.
  Pen part(double t0, double t1) const {
    const double dt = t1 - t0;
    Pen q;
    q.p = center(t0), q.a = dt * (a + t0 * b), q.b = (dt * dt) * b;
    q.w = width(t0), q.wa = dt * (wa + t0 * wb), q.wb = (dt * dt) * wb;
    return q;
  }

  /// Contains all discs.
  Box2 box() const {
    const glm::dvec2 q = p + a, r = q + (a + b);
    return grown(Box2{glm::min(glm::min(p, q), r), glm::max(glm::max(p, q), r)},
                 std::max(widest(), 0.0));
  }
};

}  // namespace mien
