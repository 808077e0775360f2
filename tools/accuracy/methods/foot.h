#pragma once
// The equation that most methods solve: where on a quadratic Bézier curve is the tangent at right angles to the point?

#include <mien/quad_bezier.h>

#include <algorithm>
#include <cmath>

namespace mien::accuracy {

/// The curve about the point, p0 − p + 2 a t + b t², in the arithmetic T, and the equation
///   f(t) = b·b t³ + 3 a·b t² + (2 a·a + q·b) t + q·a = 0,  q = p0 − p.
template <class T>
struct FootEquation {
  T qx, qy, ax, ay, bx, by;
  T c3, c2, c1, c0;

  FootEquation(const QuadBezier& c, T x, T y)
      : qx(T(c.p0.x) - x),
        qy(T(c.p0.y) - y),
        ax(T(c.p1.x) - T(c.p0.x)),
        ay(T(c.p1.y) - T(c.p0.y)),
        bx(T(c.p0.x) - 2 * T(c.p1.x) + T(c.p2.x)),
        by(T(c.p0.y) - 2 * T(c.p1.y) + T(c.p2.y)),
        c3(bx * bx + by * by),
        c2(3 * (ax * bx + ay * by)),
        c1(2 * (ax * ax + ay * ay) + (qx * bx + qy * by)),
        c0(qx * ax + qy * ay) {}

  T at(T t) const { return ((c3 * t + c2) * t + c1) * t + c0; }
  T slope(T t) const { return (3 * c3 * t + 2 * c2) * t + c1; }

  /// The squared distance from the point to the curve at t, brought into [0, 1].
  T square(T t) const {
    t = std::clamp(t, T(0), T(1));
    const T x = qx + (2 * ax + bx * t) * t, y = qy + (2 * ay + by * t) * t;
    return x * x + y * y;
  }
};

}  // namespace mien::accuracy
