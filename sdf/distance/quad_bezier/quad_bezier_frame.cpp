#include "sdf/distance/quad_bezier/quad_bezier_frame.h"
#include <mien/quad_bezier_distance.h>
#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include "lib/base/bit_cast.h"

namespace mien::batch {
namespace {

double power_of_two(int exponent) {
  return mien::bit_cast<double>(uint64_t(1023 + exponent) << 52);
}

}  // namespace

std::optional<int> scale_exponent(const QuadBezier& c) {
  const double leg = std::max(larger_side(c.p1 - c.p0), larger_side(c.p2 - c.p1));
  // A NaN hides from max, not from sums.
  const bool finite = std::isfinite(c.p0.x + c.p0.y + c.p1.x + c.p1.y + c.p2.x + c.p2.y);
  if (!(finite && leg > 0x1p-140 && leg < 0x1p124)) return std::nullopt;
  const int exponent = int(mien::bit_cast<uint64_t>(leg) >> 52) - 1022;
  return std::clamp(-exponent, -125, 125);
}

template <class T>
QuadBezierFrame<T> quad_bezier_frame(const QuadBezier& curve, int exponent) {
  const double scale = power_of_two(exponent);
  const glm::dvec2 p0 = curve.p0 * scale, a = (curve.p1 - curve.p0) * scale;
  const glm::dvec2 b = (curve.p2 - curve.p1) * scale - a, chord = 2.0 * a + b;
  const double bb = glm::dot(b, b), cc = glm::dot(chord, chord);

  QuadBezierFrame<T> f{};
  f.scale = T(scale), f.unscale = T(power_of_two(-exponent));
  f.x0 = T(p0.x), f.y0 = T(p0.y);
  f.x0_low = T(p0.x - double(f.x0)), f.y0_low = T(p0.y - double(f.y0));
  f.has_low = f.x0_low != 0 || f.y0_low != 0;
  f.ax2 = T(2 * a.x), f.ay2 = T(2 * a.y), f.bx = T(b.x), f.by = T(b.y), f.bx2 = 2 * f.bx,
  f.by2 = 2 * f.by;
  const double leg2 = std::max(glm::dot(a, a), glm::dot(a + b, a + b));
  f.straight = !(bb > leg2 * (kStraight<T> * kStraight<T>));
  if (f.straight) {
    if (cc > 0) f.chord_x = T(chord.x / cc), f.chord_y = T(chord.y / cc);
    return f;
  }

  // a = v b + w b⊥: by the cross product, so that nothing cancels when a and b are nearly parallel.
  const double r = 1 / bb, v = glm::dot(a, b) * r, w = (b.x * a.y - b.y * a.x) * r;
  f.px = T(b.x * r / 3), f.py = T(b.y * r / 3), f.p1 = T((2 * w * w - v * v) / 3);
  f.sx = T(w * b.y * r), f.sy = T(-w * b.x * r), f.s1 = T(2 * v * w * w);
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
