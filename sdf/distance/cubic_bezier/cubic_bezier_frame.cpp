#include "sdf/distance/cubic_bezier/cubic_bezier_frame.h"
#include "lib/math/norm.h"
#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::batch {
namespace {

/// Slack for rounding: the constants are rounded to the lanes' type, and so is what they are compared with.
constexpr double kMore = 1 + 0x1p-16, kSlack = 0x1p-18;

/// The exponent that brings the largest leg's larger coordinate to [1/2, 1).
std::optional<int> exponent_of(const CubicBezier& c) {
  const auto first = scale_exponent({c.p0, c.p1, c.p2}), last = scale_exponent({c.p1, c.p2, c.p3});
  const double leg =
      std::max({larger_side(c.p1 - c.p0), larger_side(c.p2 - c.p1), larger_side(c.p3 - c.p2)});
  const glm::dvec2 sum = c.p0 + c.p1 + c.p2 + c.p3;
  if (!std::isfinite(sum.x + sum.y) || !(leg > 0x1p-124 && leg < 0x1p124)) return std::nullopt;
  // The larger leg's is the least exponent; a half whose legs are all 0 has none.
  return std::min(first.value_or(125), last.value_or(125));
}

/// The curve in double precision, scaled.
struct Scaled {
  glm::dvec2 m, a, b, c, u, v, end;

  Scaled(const CubicBezier& k, double s) {
    const glm::dvec2 d0 = (k.p1 - k.p0) * s, d1 = (k.p2 - k.p1) * s, d2 = (k.p3 - k.p2) * s;
    const glm::dvec2 b0 = d1 - d0, b1 = d2 - d1;
    c = b1 - b0, v = b0 + b1, u = 0.25 * (d0 + 2.0 * d1 + d2);
    a = 3.0 * u, b = 1.5 * v, end = (k.p3 - k.p0) * s;
    m = 0.125 * (7.0 * d0 + 4.0 * d1 + d2);
  }
  glm::dvec2 at(double r) const { return m + r * (a + r * (b + r * c)); }
  glm::dvec2 slope(double r) const { return u + r * (v + r * c); }  // u
  glm::dvec2 turn(double r) const { return v + (2 * r) * c; }       // u'

  template <class T>
  CubicExpansion<T> expansion() const {
    return {T(m.x), T(m.y), T(a.x), T(a.y), T(b.x),     T(b.y),     T(c.x),   T(c.y),
            T(u.x), T(u.y), T(v.x), T(v.y), T(2 * c.x), T(2 * c.y), T(end.x), T(end.y)};
  }
};

/// A smooth number between two borders is at most this beyond the larger of its values there, if its second
/// derivative is at most `second`.
template <int kPieces>
constexpr double sag(double second) {
  return second / (8.0 * kPieces * kPieces);
}

template <class T>
void sample_and_bound(const Scaled& s, CubicFrame<T>& f) {
  constexpr int kPieces = CubicFrame<T>::kPieces;
  constexpr double h = 1.0 / kPieces;
  const double third2 = 4 * glm::dot(s.c, s.c), third = std::sqrt(third2);  // |u''|
  const double turn = glm::length(s.v) + 1.0625 * third / 2;                // |u'|
  double speed[kPieces + 1], bent[kPieces + 1], jerk[2 * kPieces + 1];
  for (int i = 0; i <= 2 * kPieces; ++i) {
    const double r = i * (h / 2) - 0.5;
    const glm::dvec2 at = s.at(r), u = s.slope(r);
    f.sample[i] = {T(at.x), T(at.y), T(u.x), T(u.y)};
    const glm::dvec2 v = s.turn(r);
    jerk[i] = 9 * glm::dot(v, v) + 24 * glm::dot(u, s.c);  // f's third derivative
    if (i % 2 != 0) continue;
    speed[i / 2] = std::sqrt(glm::dot(u, u)), bent[i / 2] = std::abs(glm::dot(u, v));
  }
  double fastest = 0, most_bent = 0;
  for (int i = 0; i < kPieces; ++i) {
    const double fast = std::max(speed[i], speed[i + 1]) + sag<kPieces>(third);
    const double begin = jerk[2 * i], middle = jerk[2 * i + 1], end = jerk[2 * i + 2];
    const double more = sag<kPieces>(30 * third2), cube = h * h * h * kMore;
    const double other = std::max(std::abs(begin - middle), std::abs(end - middle)) + more;
    const double most = std::max(std::abs(begin), std::abs(end)) + more;
    const double reach = 3 * h * fast / 4 * kMore + kSlack;
    f.piece[i] = {T(2 * reach), T(reach * reach * kMore), T(cube * most / 124),
                  T(cube * middle / 12), T(cube * (other + 0x1p-16 * most) / 12)};
    fastest = std::max(fastest, fast), most_bent = std::max({most_bent, bent[i], bent[i + 1]});
  }
  // 1/64 beyond an end |u| is at most 1/64 |u'| more, and u·u' at most (|u'|² + |u||u''|)/64.
  const double widest = fastest + turn / 64;
  const double bend =
      most_bent + sag<kPieces>(3 * turn * third) + (turn * turn + widest * third) / 64;
  f.curl = T((9 * bend + third * widest * (6 * h + 0.0625)) * kMore);
  f.curl_far = T(third * kMore);
}

}  // namespace

template <class T>
std::optional<CubicFrame<T>> cubic_frame(const CubicBezier& curve) {
  const auto exponent = exponent_of(curve);
  if (!exponent) return std::nullopt;
  const double scale = std::ldexp(1.0, *exponent);
  const glm::dvec2 p0 = curve.p0 * scale;
  const Scaled s(curve, scale);
  CubicFrame<T> f;
  f.scale = T(scale), f.unscale = T(1 / scale);
  f.x0 = T(p0.x), f.y0 = T(p0.y);
  f.x0_low = T(p0.x - double(f.x0)), f.y0_low = T(p0.y - double(f.y0));
  f.curve = s.expansion<T>(), f.fine = s.expansion<double>();

  sample_and_bound(s, f);
  return f;
}

template std::optional<CubicFrame<float>> cubic_frame<float>(const CubicBezier&);
template std::optional<CubicFrame<double>> cubic_frame<double>(const CubicBezier&);

}  // namespace mien::batch
