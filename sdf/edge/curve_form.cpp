#include <mien/sdf/edge/curve_form.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The reach of a piece of y = a x². By Federer it is the infimum over pairs of its points of the
/// radius of the circle that touches the piece at one and passes through the other, where the other
/// lies within the tangent's direction of run; a piece that turns by less than 90° has no pair
/// beyond, and by Blaschke's rolling theorem no such circle is smaller than the least radius of
/// curvature. Pieces that turn further have the reach of the whole parabola, 1/2a: its circles are
/// larger still, but the other point may lie behind an end's tangent, so they are refused.
double reach_of(double a, double lo, double hi) {
  if (a == 0.0) return kInf;
  const double steep_lo = 2.0 * a * lo, steep_hi = 2.0 * a * hi;
  const bool whole = !std::isfinite(lo) && !std::isfinite(hi);
  if (!whole && !(1.0 + steep_lo * steep_hi > 0.0)) return 0.0;  // tangents' dot product
  const double least = lo * hi <= 0.0 ? 0.0 : std::min(std::abs(steep_lo), std::abs(steep_hi));
  const double stretch = std::sqrt(1.0 + least * least);
  return stretch * stretch * stretch / (2.0 * std::abs(a));
}

std::optional<ParabolaForm> stroke_form(const QuadBezier& s, double half_width) {
  if (!(half_width > 0.0)) return {};
  const glm::dvec2 v = 2.0 * (s.p1 - s.p0), w = (s.p2 - s.p1) - (s.p1 - s.p0);
  const double bow = glm::length(w);
  ParabolaForm f{.level = half_width, .stroke = true};
  constexpr double kStraight = 1e-7;  // [px] a bow so small is none
  if (bow < kStraight) {
    const double length = glm::length(s.p2 - s.p0);
    if (!(length > 0.0) || glm::dot(v, s.p2 - s.p0) < 0.0) return {};
    if (glm::dot(v + 2.0 * w, s.p2 - s.p0) < 0.0) return {};
    f.origin = s.p0, f.right = (s.p2 - s.p0) / length;
    f.a = 0.0, f.lo = 0.0, f.hi = length;
  } else {
    const glm::dvec2 up = w / bow;
    f.right = {up.y, -up.x};
    const double run = glm::dot(v, f.right), vertex = -0.5 * glm::dot(v, up) / bow;
    f.origin = s.p0 + vertex * (v + vertex * w);
    f.a = bow / (run * run);
    const double begin = -run * vertex, end = run * (1.0 - vertex);
    f.lo = std::min(begin, end), f.hi = std::max(begin, end);
    // Farther from its vertex the frame loses digits that the curve still has.
    constexpr double kFarthest = 1e7;
    if (!(std::max(-f.lo, f.hi) < kFarthest) || !(f.a < 1e9)) return {};
  }
  f.reach = reach_of(f.a, f.lo - ParabolaForm::kMargin, f.hi + ParabolaForm::kMargin);
  return f;
}

}  // namespace

std::optional<ParabolaForm> parabola_form(const OffsetShape& shape) {
  if (const auto* s = std::get_if<QuadStroke>(&shape.shape))
    return stroke_form(s->spine, s->half_width + shape.offset);
  if (const auto* s = std::get_if<Line>(&shape.shape))
    return stroke_form({s->a, 0.5 * (s->a + s->b), s->b}, s->half_width + shape.offset);
  if (const auto* s = std::get_if<ParabolaSide>(&shape.shape)) {
    // The inside is above; grown by offset, its outline runs below the parabola.
    if (!(std::abs(s->bend) < 1e9)) return {};
    return ParabolaForm{.origin = s->vertex,
                        .right = {s->axis.y, -s->axis.x},
                        .a = s->bend,
                        .lo = -kInf,
                        .hi = kInf,
                        .level = -shape.offset,
                        .stroke = false,
                        .reach = reach_of(s->bend, -kInf, kInf)};
  }
  return {};
}

std::optional<EllipseForm> ellipse_form(const OffsetShape& shape) {
  const auto* s = std::get_if<Ellipse>(&shape.shape);
  if (!s || shape.offset != 0.0) return {};
  const double small = std::min(s->radii.x, s->radii.y), large = std::max(s->radii.x, s->radii.y);
  if (!(small > 1e-9 && large < 1e12)) return {};
  return EllipseForm{s->center, s->axis, s->radii.x, s->radii.y, small * small / large};
}

}  // namespace mien
