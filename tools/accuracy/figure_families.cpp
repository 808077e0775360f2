// Families of the other figures: ellipses, parabola sides, tapered strokes, cubic Bézier curves.

#include "tools/accuracy/families.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace mien::accuracy {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

glm::dvec2 left_of(glm::dvec2 v) {
  return {-v.y, v.x};
}

/// Half the time upright, so that coordinates on the axes are exact.
glm::dvec2 some_axis(Random& r) {
  return r.chance(0.5) ? glm::dvec2{1, 0} : glm::normalize(r.direction());
}

Ellipse some_ellipse(Random& r, double ratio) {
  const glm::dvec2 centre = r.point(), radii{1, ratio};
  const double size = r.between(0.2, 2);
  return {centre, size * (r.chance(0.5) ? radii : glm::dvec2{radii.y, radii.x}), some_axis(r)};
}

glm::dvec2 placed(const Ellipse& e, glm::dvec2 q) {
  return e.center + q.x * e.axis + q.y * left_of(e.axis);
}

glm::dvec2 rim(const Ellipse& e, double angle) {
  return {e.radii.x * std::cos(angle), e.radii.y * std::sin(angle)};
}

Case ellipse_anywhere(Random& r) {
  const Ellipse e = some_ellipse(r, r.between(0.05, 1));
  return {e, 4.0 * r.point() - 2.0};
}
Case ellipse_thin(Random& r) {
  const Ellipse e = some_ellipse(r, r.magnitude(-2.9, -1));
  return {e, e.center + 2.0 * r.point() - 1.0};
}
Case ellipse_rim(Random& r) {
  const Ellipse e = some_ellipse(r, r.magnitude(-2, 0));
  return {e, placed(e, rim(e, r.between(0, kTurn))) + r.magnitude(-9, -1) * r.direction()};
}
Case ellipse_axes(Random& r) {
  const Ellipse e = some_ellipse(r, r.magnitude(-2, 0));
  const double along = r.between(-2, 2), off = r.chance(0.3) ? 0 : r.magnitude(-12, -2) * r.sign();
  return {e, placed(e, r.chance(0.5) ? glm::dvec2{along, off} : glm::dvec2{off, along})};
}
Case ellipse_evolute(Random& r) {
  const Ellipse e = some_ellipse(r, r.magnitude(-1.5, 0));
  const double a = e.radii.x, b = e.radii.y, angle = r.chance(0.3) ? 0 : r.between(0, kTurn);
  const double c = std::cos(angle), s = std::sin(angle), focal = a * a - b * b;
  const glm::dvec2 centre{focal * c * c * c / a, -focal * s * s * s / b};
  return {e, placed(e, centre) + (r.chance(0.2) ? 0 : r.magnitude(-9, -2)) * r.direction()};
}
Case circle(Random& r) {
  const Ellipse e = some_ellipse(r, r.chance(0.7) ? 1 : 1 - r.magnitude(-8, -3));
  const double away = r.chance(0.1) ? 0 : r.magnitude(-6, 0.5);
  return {e, e.center + away * r.direction()};
}
Case ellipse_far(Random& r) {
  const Ellipse e = some_ellipse(r, r.magnitude(-2.9, 0));
  return {e, r.magnitude(1, 12) * r.direction()};
}

ParabolaSide some_side(Random& r, double bend) {
  return {r.point(), some_axis(r), bend * r.sign()};
}

glm::dvec2 placed(const ParabolaSide& s, double across, double along) {
  return s.vertex + across * left_of(s.axis) + along * s.axis;
}

Case parabola_anywhere(Random& r) {
  const ParabolaSide s = some_side(r, r.magnitude(-2, 2));
  return {s, 6.0 * r.point() - 3.0};
}
Case parabola_rim(Random& r) {
  const ParabolaSide s = some_side(r, r.magnitude(-2, 2));
  const double u = r.between(-2, 2);
  return {s, placed(s, u, s.bend * u * u) + r.magnitude(-9, -1) * r.direction()};
}
Case parabola_evolute(Random& r) {
  const ParabolaSide s = some_side(r, r.magnitude(-1, 1));
  const double u = r.chance(0.3) ? 0 : r.between(-1, 1), k = s.bend;
  const glm::dvec2 at = placed(s, -4 * k * k * u * u * u, 3 * k * u * u + 0.5 / k);
  return {s, at + (r.chance(0.2) ? 0 : r.magnitude(-9, -2)) * r.direction()};
}
Case parabola_axis(Random& r) {
  const ParabolaSide s = some_side(r, r.magnitude(-2, 2));
  return {s, placed(s, r.chance(0.3) ? 0 : r.magnitude(-12, -2) * r.sign(), r.between(-3, 3))};
}
Case parabola_extreme(Random& r) {
  const ParabolaSide s = some_side(r, r.magnitude(-12, 12));
  return {s, 4.0 * r.point() - 2.0};
}

QuadBezier some_spine(Random& r) {
  const glm::dvec2 p0 = r.point(), p1 = r.point();
  return {p0, p1, r.point()};
}
Case stroke_anywhere(Random& r) {
  const TaperedStroke s{some_spine(r), {0.3 * r.unit(), 0.3 * r.unit(), 0.3 * r.unit()}};
  return {s, 3.0 * r.point() - 1.0};
}
Case stroke_wide(Random& r) {  // the widths change faster than the spine moves
  const TaperedStroke s{some_spine(r), {2 * r.unit(), 2 * r.unit(), 2 * r.unit()}};
  return {s, 6.0 * r.point() - 3.0};
}
Case stroke_line(Random& r) {
  const glm::dvec2 a = r.point(), b = r.point();
  const TaperedStroke s{{a, 0.5 * (a + b), b}, {0.2 * r.unit(), 0.2 * r.unit(), 0.2 * r.unit()}};
  return {s, 3.0 * r.point() - 1.0};
}
/// Around the spine, the rim and the spine's evolute, where feet meet or run along.
Case stroke_delicate(Random& r) {
  const TaperedStroke s{some_spine(r), {0.3 * r.unit(), 0.3 * r.unit(), 0.3 * r.unit()}};
  const double t = r.unit();
  const glm::dvec2 g = tangent(s.spine, t), b = bend(s.spine), n = glm::normalize(left_of(g));
  const double w = (1 - t) * (1 - t) * s.half_width[0] + 2 * t * (1 - t) * s.half_width[1] +
                   t * t * s.half_width[2];
  const double radius = glm::dot(g, g) * glm::length(g) / (g.x * b.y - g.y * b.x);
  const double away[] = {0, w * r.sign(), std::abs(radius) < 5 ? radius : 0};
  const glm::dvec2 off = (r.chance(0.2) ? 0 : r.magnitude(-9, -1)) * r.direction();
  return {s, point(s.spine, t) + away[r.bits() % 3] * n + off};
}
/// Close to the spine, where the depth has a kink, with half-widths that grow nearly as fast as the
/// spine goes; half of the time an end is just as deep.
Case stroke_kink(Random& r) {
  TaperedStroke s{some_spine(r), {0, 0, 0}};
  const double t = r.unit(), steep = r.between(-1.2, 1.2);
  const double w0 = 0.2 * r.unit(), slope = steep * glm::length(tangent(s.spine, t));
  double* w = s.half_width;
  w[0] = w0, w[2] = 0.4 * r.unit();
  w[1] = w[0] + 0.5 * (slope - t * (w[2] - w[0]));  // w' is about the slope at t
  const double off = r.chance(0.1) ? 0 : r.magnitude(-8, -1);
  const glm::dvec2 p = point(s.spine, t) + off * r.direction();
  if (r.chance(0.5)) {
    const double at = (1 - t) * (1 - t) * w[0] + 2 * t * (1 - t) * w[1] + t * t * w[2];
    const double depth = glm::distance(p, point(s.spine, t)) - at;
    w[2] = glm::distance(p, s.spine.p2) - depth + r.magnitude(-9, -2) * r.sign();
  }
  for (double& v : s.half_width) v = std::max(v, 0.0);
  return {s, p};
}
Case stroke_far(Random& r) {
  Case k = stroke_anywhere(r);
  k.p = r.magnitude(0, 7) * r.direction();
  return k;
}

CubicBezier some_cubic(Random& r) {
  const glm::dvec2 p0 = r.point(), p1 = r.point(), p2 = r.point();
  return {p0, p1, p2, r.point()};
}
Case cubic_anywhere(Random& r) {
  const CubicBezier c = some_cubic(r);
  return {c, 3.0 * r.point() - 1.0};
}
Case cubic_rim(Random& r) {
  const CubicBezier c = some_cubic(r);
  return {c, point(c, r.unit()) + (r.chance(0.3) ? 0 : r.magnitude(-9, -2)) * r.direction()};
}
Case cubic_evolute(Random& r) {
  for (;;) {
    const CubicBezier c = some_cubic(r);
    const double t = r.unit(), h = 1e-4;
    const glm::dvec2 g = tangent(c, t), b = (tangent(c, t + h) - tangent(c, t - h)) / (2 * h);
    const glm::dvec2 e = point(c, t) + left_of(g) * (glm::dot(g, g) / (g.x * b.y - g.y * b.x));
    if (glm::length(e) < 5)
      return {c, e + (r.chance(0.2) ? 0 : r.magnitude(-9, -2)) * r.direction()};
  }
}
Case cubic_degenerate(Random& r) {  // a raised quadratic, a line, coincident control points
  CubicBezier c = some_cubic(r);
  switch (r.bits() % 4) {
    case 0:
      c.p1 = c.p0;
      break;
    case 1:
      c.p1 = c.p2 = c.p3;
      break;
    case 2:
      c.p1 = c.p0 + (c.p3 - c.p0) * 0.25, c.p2 = c.p0 + (c.p3 - c.p0) * r.between(-1, 2);
      break;
    default:
      c.p3 = c.p0, c.p2 = c.p1;
  }
  return {c, 3.0 * r.point() - 1.0};
}

/// At any scale, far from the origin, or seen from afar.
Case cubic_far(Random& r) {
  CubicBezier c = some_cubic(r);
  glm::dvec2 p = 3.0 * r.point() - 1.0;
  if (r.chance(0.3)) p = r.magnitude(0, 9) * r.direction();
  const double scale = r.chance(0.3) ? r.magnitude(-12, 12) : 1;
  const glm::dvec2 off = r.chance(0.3) ? r.magnitude(0, 5) * r.direction() : glm::dvec2(0.0);
  for (glm::dvec2* v : {&c.p0, &c.p1, &c.p2, &c.p3, &p}) *v = scale * (*v + off);
  return {c, p};
}
/// A cusp at some parameter, or nearly: seen from around it.
Case cubic_cusp(Random& r) {
  CubicBezier c = some_cubic(r);
  const double t = r.between(0.05, 0.95), s = 1 - t;
  const glm::dvec2 u0 = c.p1 - c.p0, u2 = c.p3 - c.p2;
  const glm::dvec2 u1 = -(s * s * u0 + t * t * u2) / (2 * s * t);  // B'(t) = 0
  c.p2 = c.p1 + u1 + (r.chance(0.3) ? 0 : r.magnitude(-8, -1)) * r.direction();
  c.p3 = c.p2 + u2;
  return {c, point(c, t) + (r.chance(0.1) ? 0 : r.magnitude(-9, 0)) * r.direction()};
}
/// Mirrored curves seen from about their mirror, where two feet are equally far.
Case cubic_tie(Random& r) {
  const glm::dvec2 p0 = r.point(), p1 = r.point(), centre = r.point();
  const auto mirrored = [&](glm::dvec2 v) { return glm::dvec2{2 * centre.x - v.x, v.y}; };
  const double off = r.chance(0.3) ? 0 : r.magnitude(-9, -2) * r.sign();
  return {CubicBezier{p0, p1, mirrored(p1), mirrored(p0)}, {centre.x + off, r.between(-1, 2)}};
}

}  // namespace

std::vector<Family> conic_families() {
  return {
      {"ellipse", ellipse_anywhere},         {"ellipse, thin", ellipse_thin},
      {"ellipse, rim", ellipse_rim},         {"ellipse, axes", ellipse_axes},
      {"ellipse, evolute", ellipse_evolute}, {"circle", circle},
      {"ellipse, far", ellipse_far},         {"parabola", parabola_anywhere},
      {"parabola, rim", parabola_rim},       {"parabola, evolute", parabola_evolute},
      {"parabola, axis", parabola_axis},     {"parabola, any bend", parabola_extreme},
  };
}

std::vector<Family> stroke_families() {
  return {
      {"tapered stroke", stroke_anywhere},
      {"tapered stroke, wide", stroke_wide},
      {"tapered stroke, line", stroke_line},
      {"tapered stroke, delicate", stroke_delicate},
      {"tapered stroke, kink", stroke_kink},
      {"tapered stroke, far", stroke_far},
      {"cubic", cubic_anywhere},
      {"cubic, rim", cubic_rim},
      {"cubic, evolute", cubic_evolute},
      {"cubic, degenerate", cubic_degenerate},
      {"cubic, far", cubic_far},
      {"cubic, cusp", cubic_cusp},
      {"cubic, tie", cubic_tie},
  };
}

}  // namespace mien::accuracy
