#include "sdf/distance/conic/conic_frame.h"

#include <algorithm>
#include <cmath>

namespace mien::batch {
namespace {

template <class T, class Frame>
void place(Frame& f, double x, double y) {
  f.x0 = T(x), f.low_x = T(x - double(f.x0));
  f.y0 = T(y), f.low_y = T(y - double(f.y0));
}

bool in_range(double x) {
  return x > 0x1p-100 && x < 0x1p100;
}

}  // namespace

template <class T>
std::optional<EllipseFrame<T>> ellipse_frame(const Ellipse& e) {
  const double longer = std::max(e.radii.x, e.radii.y), shorter = std::min(e.radii.x, e.radii.y);
  if (!(in_range(e.radii.x) && in_range(e.radii.y) && shorter >= longer * kThinnest)) {
    return std::nullopt;
  }
  if (!(std::abs(e.center.x) < 0x1p100 && std::abs(e.center.y) < 0x1p100)) return std::nullopt;
  int exponent = 0;
  std::frexp(longer, &exponent);
  const double scale = std::ldexp(1.0, -exponent), a = longer * scale, b = shorter * scale;
  EllipseFrame<T> f{};
  f.scale = T(scale), f.unscale = T(1 / scale);
  place<T>(f, e.center.x * scale, e.center.y * scale);
  const bool turned = e.radii.y > e.radii.x;
  f.axis_x = T(turned ? -e.axis.y : e.axis.x), f.axis_y = T(turned ? e.axis.x : e.axis.y);
  f.a = T(a), f.b = T(b);
  f.focal = T((a - b) * (a + b));
  f.guess_focal = std::max(f.focal, T(1e-6 * a * a));
  return f;
}

template <class T>
std::optional<ParabolaFrame<T>> parabola_frame(const ParabolaSide& side) {
  const double bend = std::abs(side.bend);
  if (!in_range(bend)) return std::nullopt;
  const double reach = std::max(std::abs(side.vertex.x), std::abs(side.vertex.y));
  if (!(reach < 0x1p100)) return std::nullopt;
  ParabolaFrame<T> f{};
  f.scale = T(bend), f.unscale = T(1 / bend);
  place<T>(f, side.vertex.x, side.vertex.y);
  f.mirrored = side.bend < 0;
  const double sign = f.mirrored ? -1 : 1;
  f.axis_x = T(sign * side.axis.x), f.axis_y = T(sign * side.axis.y);
  return f;
}

template std::optional<EllipseFrame<float>> ellipse_frame<float>(const Ellipse&);
template std::optional<EllipseFrame<double>> ellipse_frame<double>(const Ellipse&);
template std::optional<ParabolaFrame<float>> parabola_frame<float>(const ParabolaSide&);
template std::optional<ParabolaFrame<double>> parabola_frame<double>(const ParabolaSide&);

}  // namespace mien::batch
