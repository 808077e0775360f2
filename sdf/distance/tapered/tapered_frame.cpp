#include "sdf/distance/tapered/tapered_frame.h"
#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::batch {
namespace {

/// Beyond it the roots x = t + v lose more than ten bits of t.
constexpr double kFarthestVertex = 64;

}  // namespace

template <class T>
std::optional<TaperedFrame<T>> tapered_frame(const TaperedStroke& stroke) {
  const auto exponent = scale_exponent(stroke.spine);
  const double* w = stroke.half_width;
  const double widest = std::max({std::abs(w[0]), std::abs(w[1]), std::abs(w[2])});
  if (!exponent || !std::isfinite(w[0] + w[1] + w[2])) return std::nullopt;
  TaperedFrame<T> f{quad_bezier_frame<T>(stroke.spine, *exponent)};
  const double scale = double(f.spine.scale);
  if (f.spine.straight || !(widest * scale < 0x1p10)) return std::nullopt;

  const QuadBezier& c = stroke.spine;
  const glm::dvec2 a = (c.p1 - c.p0) * scale, b = (c.p2 - c.p1) * scale - a;
  const double w0 = w[0] * scale, wa = (w[1] - w[0]) * scale, wb = (w[2] - w[1]) * scale - wa;
  // Products in which the last coordinate counts negatively.
  const double aa = glm::dot(a, a) - wa * wa, ab = glm::dot(a, b) - wa * wb;
  const double bb = glm::dot(b, b) - wb * wb;
  const double leg2 = std::max(glm::dot(a, a), glm::dot(a + b, a + b)) + wa * wa;
  if (!(bb > leg2 * (kStraight<float> * kStraight<float>))) return std::nullopt;
  const double r = 1 / bb, v = ab * r;
  if (!(std::abs(v) < kFarthestVertex)) return std::nullopt;
  f.w0 = T(w0), f.wa2 = T(2 * wa), f.wb = T(wb), f.wb2 = 2 * f.wb;
  f.px = T(b.x * r / 3), f.py = T(b.y * r / 3), f.pw = T(-wb * r / 3);
  f.p1 = T((2 * aa - w0 * wb) * r / 3 - v * v);
  const double sw = (wa - v * wb) * r;
  f.sx = T((v * b.x - a.x) * r), f.sy = T((v * b.y - a.y) * r), f.sw = T(sw);
  f.s1 = T(2 * v * aa * r - 2 * v * v * v + sw * w0);
  f.vertex = T(v);
  const double steepest = std::sqrt(4 * leg2) + 2 * std::max(std::abs(wa), std::abs(wa + wb));
  const double change = 0x1p-16 * (1 + std::abs(v)) * steepest;
  f.steep2 = T(steepest * steepest / 2), f.least_lead = T(change * change / 2);
  return f;
}

template std::optional<TaperedFrame<float>> tapered_frame<float>(const TaperedStroke&);
template std::optional<TaperedFrame<double>> tapered_frame<double>(const TaperedStroke&);

double depth_at(const TaperedStroke& stroke, double t, glm::dvec2 p) {
  const double* w = stroke.half_width;
  const double s = 1 - t, width = s * (s * w[0] + t * w[1]) + t * (s * w[1] + t * w[2]);
  const QuadBezier& c = stroke.spine;
  const glm::dvec2 on = s * (s * c.p0 + t * c.p1) + t * (s * c.p1 + t * c.p2);
  return norm(p - on) - width;
}

}  // namespace mien::batch
