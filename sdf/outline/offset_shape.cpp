#include "sdf/outline/outline_maker.h"

#include <algorithm>

namespace mien {
namespace {

/// Nothing but perhaps a point.
const Shape kNothing = Disc{{0.0, 0.0}, 0.0};

std::optional<Shape> offset(HalfPlane s, double amount) {
  s.offset += amount;
  return s;
}

std::optional<Shape> offset(Disc s, double amount) {
  s.radius = std::max(0.0, s.radius + amount);
  return s;
}

/// Line, Polyline, QuadStroke: distance = distance to the spine − half-width.
template <class Stroke>
std::optional<Shape> wider(Stroke s, double amount) {
  s.half_width += amount;
  if (s.half_width < 0.0) return kNothing;
  return s;
}
std::optional<Shape> offset(const Line& s, double amount) {
  return wider(s, amount);
}
std::optional<Shape> offset(const Polyline& s, double amount) {
  return wider(s, amount);
}
std::optional<Shape> offset(const QuadStroke& s, double amount) {
  return wider(s, amount);
}

/// distance = min over t of |p − B(t)| − w(t): every width grows. Widths below 0 are no discs.
std::optional<Shape> offset(TaperedStroke s, double amount) {
  for (double& w : s.half_width) w += amount;
  return s;
}

template <class Other>
std::optional<Shape> offset(const Other&, double) {
  return {};
}

}  // namespace

std::optional<Shape> offset_shape(const Shape& shape, double amount) {
  return std::visit([&](const auto& s) { return offset(s, amount); }, shape);
}

std::optional<TaperedStroke> tapered(const Shape& shape) {
  if (const auto* even = std::get_if<QuadStroke>(&shape))
    return TaperedStroke{even->spine, {even->half_width, even->half_width, even->half_width}};
  const auto* stroke = std::get_if<TaperedStroke>(&shape);
  return stroke ? std::optional(*stroke) : std::nullopt;
}

}  // namespace mien
