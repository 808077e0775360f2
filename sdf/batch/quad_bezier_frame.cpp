#include <mien/sdf/batch/quad_bezier_frame.h>
#include <mien/sdf/shape/quad_bezier.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien::batch {
namespace {

double larger_leg(const QuadBezier& c) {
  return std::max(std::hypot(c.p1.x - c.p0.x, c.p1.y - c.p0.y),
                  std::hypot(c.p2.x - c.p1.x, c.p2.y - c.p1.y));
}

}  // namespace

int scale_exponent(const QuadBezier& curve) {
  const double leg = larger_leg(curve);
  if (!(leg > 0 && std::isfinite(leg))) return 0;
  int exponent = 0;
  std::frexp(leg, &exponent);
  return std::clamp(-exponent, -125, 125);
}

bool has_frame(const QuadBezier& c) {
  const double farthest = std::max({std::abs(c.p0.x), std::abs(c.p0.y), std::abs(c.p1.x),
                                    std::abs(c.p1.y), std::abs(c.p2.x), std::abs(c.p2.y)});
  const double leg = larger_leg(c);
  return leg > 0x1p-140 && leg < 0x1p124 && std::isfinite(farthest);
}

template <class T>
QuadBezierFrame<T> quad_bezier_frame(const QuadBezier& curve, int exponent) {
  const double scale = std::ldexp(1.0, exponent);
  const glm::dvec2 p0 = curve.p0 * scale, a = (curve.p1 - curve.p0) * scale;
  const glm::dvec2 b = (curve.p2 - curve.p1) * scale - a, chord = 2.0 * a + b;
  const double bb = glm::dot(b, b), cc = glm::dot(chord, chord);
  const double leg = larger_leg(curve) * scale;

  QuadBezierFrame<T> f{};
  f.scale = T(scale), f.unscale = T(1 / scale);
  f.x0 = T(p0.x), f.y0 = T(p0.y);
  f.x0_low = T(p0.x - double(f.x0)), f.y0_low = T(p0.y - double(f.y0));
  f.has_low = f.x0_low != 0 || f.y0_low != 0;
  f.ax2 = T(2 * a.x), f.ay2 = T(2 * a.y), f.bx = T(b.x), f.by = T(b.y), f.bx2 = 2 * f.bx,
  f.by2 = 2 * f.by;
  if (cc > 0) f.chord_x = T(chord.x / cc), f.chord_y = T(chord.y / cc);
  f.straight = !(std::sqrt(bb) > leg * kStraight<T>);
  if (f.straight) return f;

  // a = v b + w b⊥: by the cross product, so that nothing cancels when a and b are nearly parallel.
  const double v = glm::dot(a, b) / bb, w = (b.x * a.y - b.y * a.x) / bb;
  f.px = T(b.x / (3 * bb)), f.py = T(b.y / (3 * bb)), f.p1 = T((2 * w * w - v * v) / 3);
  f.sx = T(w * b.y / bb), f.sy = T(-w * b.x / bb), f.s1 = T(2 * v * w * w);
  f.vertex = T(v);
  return f;
}

template QuadBezierFrame<float> quad_bezier_frame<float>(const QuadBezier&, int);
template QuadBezierFrame<double> quad_bezier_frame<double>(const QuadBezier&, int);

double distance_to_nearest(std::span<const QuadBezier> curves, glm::dvec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const QuadBezier& curve : curves) least = std::min(least, distance(curve, p));
  return least;
}

}  // namespace mien::batch
