#include <mien/sdf/edge/curve_form.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The reach of a piece of y = a x², or a bound below it. By Federer it is the infimum, over pairs
/// of its points p and q, of the radius of the circle that touches the piece at p and passes through
/// q; where p is an end and q lies behind its tangent, of half their distance.
/// Whole parabola: 1/2a, the radius at the vertex. So for any piece no touching circle is smaller,
/// and q behind an end at x = e lies beyond the end's normal, which meets the parabola again at
/// −e − 1/(2a²e): half the distance is at least e + 1/(4a²e) >= 1/a.
/// A piece that turns by less than 90° has no q behind an end, and by Blaschke's rolling theorem no
/// touching circle is smaller than its own least radius of curvature.
double reach_of(double a, double lo, double hi) {
  if (a == 0.0) return kInf;
  const double steep_lo = 2.0 * a * lo, steep_hi = 2.0 * a * hi;
  const bool turns_little = 1.0 + steep_lo * steep_hi > 0.0;  // the tangents' dot product
  const double least =
      lo * hi <= 0.0 || !turns_little ? 0.0 : std::min(std::abs(steep_lo), std::abs(steep_hi));
  const double stretch = std::sqrt(1.0 + least * least);
  return stretch * stretch * stretch / (2.0 * std::abs(a));
}

std::optional<ParabolaForm> stroke_form(const QuadBezier& s, double half_width) {
  if (!(half_width > 0.0)) return {};
  const auto piece = parabola_piece(s);
  if (!piece) return {};
  ParabolaForm f = piece->form;
  f.level = half_width, f.stroke = true;
  f.reach = reach_of(f, ParabolaForm::kMargin);
  return f;
}

}  // namespace

std::optional<ParabolaPiece> parabola_piece(const QuadBezier& s) {
  const glm::dvec2 v = 2.0 * (s.p1 - s.p0), w = (s.p2 - s.p1) - (s.p1 - s.p0);
  const double bow = glm::length(w), length = glm::length(s.p2 - s.p0);
  ParabolaForm f{.level = 0.0, .stroke = false};
  constexpr double kStraight = 1e-7;  // [px] a bow so small is none
  if (bow < kStraight) {
    if (!(length > 0.0) || glm::dot(v, s.p2 - s.p0) < 0.0) return {};
    if (glm::dot(v + 2.0 * w, s.p2 - s.p0) < 0.0) return {};
    f.origin = s.p0, f.right = (s.p2 - s.p0) / length;
    f.a = 0.0, f.lo = 0.0, f.hi = length;
    return ParabolaPiece{f, true};
  }
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
  return ParabolaPiece{f, run > 0.0};
}

double reach_of(const ParabolaForm& form, double margin) {
  const double a = std::abs(form.a);
  // The x at arc `margin` from the end x = e towards the vertex, or beyond it: the arc from x to e on one
  // flank is at least a (e² − x²), and anywhere at least e − x.
  const auto inwards = [&](double e) {
    const double square = e * e - margin / a;
    return std::max(square > 0.0 ? std::sqrt(square) : -kInf, std::abs(e) - margin);
  };
  double lo = form.lo - margin, hi = form.hi + margin;
  if (a > 0.0 && form.lo > 0.0) lo = inwards(form.lo);
  if (a > 0.0 && form.hi < 0.0) hi = -inwards(form.hi);
  return reach_of(form.a, lo, hi);
}

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
