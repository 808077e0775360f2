#include <mien/sdf/batch/conic_frame.h>

#include <algorithm>
#include <cmath>

namespace mien::batch {
namespace {

template <class Frame>
void place(Frame& f, double x, double y) {
  f.x0 = float(x), f.low_x = float(x - double(f.x0));
  f.y0 = float(y), f.low_y = float(y - double(f.y0));
}

bool in_range(double x) {
  return x > 0x1p-100 && x < 0x1p100;
}

}  // namespace

std::optional<EllipseFrame> ellipse_frame(const Ellipse& e) {
  const double longer = std::max(e.radii.x, e.radii.y), shorter = std::min(e.radii.x, e.radii.y);
  if (!(in_range(e.radii.x) && in_range(e.radii.y) && shorter >= longer * kThinnest)) {
    return std::nullopt;
  }
  if (!(std::abs(e.center.x) < 0x1p100 && std::abs(e.center.y) < 0x1p100)) return std::nullopt;
  int exponent = 0;
  std::frexp(longer, &exponent);
  const double scale = std::ldexp(1.0, -exponent), a = longer * scale, b = shorter * scale;
  EllipseFrame f{};
  f.scale = float(scale), f.unscale = float(1 / scale);
  place(f, e.center.x * scale, e.center.y * scale);
  const bool turned = e.radii.y > e.radii.x;
  f.axis_x = float(turned ? -e.axis.y : e.axis.x), f.axis_y = float(turned ? e.axis.x : e.axis.y);
  f.a = float(a), f.b = float(b);
  f.focal = float((a - b) * (a + b));
  f.guess_focal = std::max(f.focal, float(1e-6 * a * a));
  return f;
}

std::optional<ParabolaFrame> parabola_frame(const ParabolaSide& side) {
  const double bend = std::abs(side.bend);
  if (!in_range(bend)) return std::nullopt;
  const double reach = std::max(std::abs(side.vertex.x), std::abs(side.vertex.y));
  if (!(reach < 0x1p100)) return std::nullopt;
  ParabolaFrame f{};
  f.scale = float(bend), f.unscale = float(1 / bend);
  place(f, side.vertex.x, side.vertex.y);
  f.mirrored = side.bend < 0;
  const double sign = f.mirrored ? -1 : 1;
  f.axis_x = float(sign * side.axis.x), f.axis_y = float(sign * side.axis.y);
  return f;
}

}  // namespace mien::batch
