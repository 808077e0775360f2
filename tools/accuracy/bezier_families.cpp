#include "tools/accuracy/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace mien::accuracy {
namespace {

struct BezierCase {
  QuadBezier curve;
  glm::dvec2 p;
  operator Case() const { return {curve, p}; }
};

QuadBezier random_curve(Random& r) {
  const glm::dvec2 p0 = r.point(), p1 = r.point();
  return {p0, p1, r.point()};
}

/// A quarter of the time exactly at `at`, else off it by 1e-12 … 1e-2.
glm::dvec2 near(Random& r, glm::dvec2 at) {
  return r.chance(0.25) ? at : at + r.magnitude(-12, -2) * r.direction();
}

double vertex_of(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  return -glm::dot(a, b) / glm::dot(b, b);
}

glm::dvec2 centre_of_curvature(const QuadBezier& c, double t) {
  const glm::dvec2 g = tangent(c, t), b = bend(c);
  return point(c, t) + glm::dvec2(-g.y, g.x) * (glm::dot(g, g) / (g.x * b.y - g.y * b.x));
}

bool within(glm::dvec2 p, double reach) {
  return std::abs(p.x) < reach && std::abs(p.y) < reach;
}

BezierCase random_case(Random& r) {
  const QuadBezier curve = random_curve(r);
  return {curve, r.point()};
}

BezierCase on_curve(Random& r) {
  const QuadBezier c = random_curve(r);
  return {c, point(c, r.unit())};
}

BezierCase near_curve(Random& r) {
  const QuadBezier c = random_curve(r);
  return {c, point(c, r.unit()) + r.magnitude(-7, -2) * r.direction()};
}

BezierCase near_an_end(Random& r) {  // where clamping begins
  const QuadBezier c = random_curve(r);
  const double t = (r.chance(0.5) ? 0 : 1) + r.magnitude(-8, -1) * r.sign();
  const glm::dvec2 g = tangent(c, t);
  return {c, point(c, t) + glm::dvec2(-g.y, g.x) * r.magnitude(-6, 0) * r.sign()};
}

BezierCase evolute(Random& r) {
  for (;;) {
    const QuadBezier c = random_curve(r);
    const glm::dvec2 e = centre_of_curvature(c, r.unit());
    if (within(e, 4)) return {c, near(r, e)};
  }
}

BezierCase evolute_cusp(Random& r) {
  for (;;) {
    const QuadBezier c = random_curve(r);
    const double t = vertex_of(c);
    const glm::dvec2 e = centre_of_curvature(c, t);
    if (t > -0.2 && t < 1.2 && within(e, 4)) return {c, near(r, e)};
  }
}

BezierCase on_axis(Random& r) {
  for (;;) {
    const QuadBezier c = random_curve(r);
    const glm::dvec2 b = glm::normalize(bend(c));
    const double t = vertex_of(c), off = r.chance(0.25) ? 0 : r.magnitude(-12, -2) * r.sign();
    const glm::dvec2 p = point(c, t) + r.between(-1, 1) * b + off * glm::dvec2(-b.y, b.x);
    if (t > -1 && t < 2 && within(p, 4)) return {c, p};
  }
}

BezierCase collinear(Random& r) {  // exactly: multiples of small whole steps
  constexpr std::array<glm::dvec2, 4> kDirections{{{1, 0}, {0, 1}, {1, 1}, {3, -2}}};
  const glm::dvec2 v = kDirections[r.bits() % 4] * 0x1p-12;
  const auto whole = [&] { return std::floor(r.between(-2048, 2048)); };
  const QuadBezier c{whole() * v, whole() * v, whole() * v};
  return {c, r.chance(0.3) ? point(c, r.unit()) : r.point()};
}

QuadBezier nearly_straight(Random& r, double smallest) {
  const double off = r.magnitude(smallest, -1) * r.sign();
  const double at = r.chance(0.5) ? 0.5 + r.between(-1, 1) * r.magnitude(-8, -1) : r.unit();
  if (r.chance(0.5)) return {{0, 0}, {at, off}, {1, 0}};
  const glm::dvec2 p0 = r.point(), p2 = r.point(), v = p2 - p0;
  return {p0, p0 + at * v + off * glm::dvec2(-v.y, v.x), p2};
}

BezierCase near_collinear(Random& r) {
  const QuadBezier c = nearly_straight(r, -12);
  if (r.chance(0.2)) return {c, point(c, r.unit()) + glm::dvec2(0, r.magnitude(-9, -3))};
  return {c, r.point()};
}

BezierCase straight_from_afar(
    Random& r) {  // nearly straight, around its far evolute: three near-minima
  for (;;) {
    const QuadBezier c = nearly_straight(r, -5);
    const glm::dvec2 e = centre_of_curvature(c, r.unit()), mid = point(c, 0.5);
    if (within(e, 1e6)) return {c, near(r, mid + (e - mid) * r.between(0.9, 1.2))};
  }
}

BezierCase folded(
    Random& r) {  // the control point beyond an end, nearly on the line: a thin parabola
  const double off = r.magnitude(-9, -2) * r.sign(), at = r.chance(0.5) ? -r.unit() : 1 + r.unit();
  const QuadBezier c{{0, 0}, {at, off}, {1, 0}};
  const double t = r.chance(0.5) ? r.unit() : vertex_of(c);
  return {c, point(c, t) + r.magnitude(-9, 0) * r.direction()};
}

BezierCase first_two_equal(Random& r) {
  BezierCase k = random_case(r);
  k.curve.p1 = k.curve.p0;
  return k;
}

BezierCase last_two_equal(Random& r) {
  BezierCase k = random_case(r);
  k.curve.p1 = k.curve.p2;
  return k;
}

BezierCase ends_equal(Random& r) {
  BezierCase k = random_case(r);
  k.curve.p2 = k.curve.p0;
  return k;
}

BezierCase all_equal(Random& r) {
  BezierCase k = random_case(r);
  k.curve.p1 = k.curve.p2 = k.curve.p0;
  return k;
}

BezierCase nearly_equal(Random& r) {  // three control points within 1e-7 … 1e-1 of two
  BezierCase k = random_case(r);
  const glm::dvec2 step = r.magnitude(-7, -1) * r.direction();
  (r.chance(0.5) ? k.curve.p1 : k.curve.p2) = (r.chance(0.5) ? k.curve.p0 : k.curve.p1) + step;
  return k;
}

BezierCase far_away(Random& r) {
  const QuadBezier curve = random_curve(r);
  return {curve, r.magnitude(3, 6) * r.direction()};
}

BezierCase beyond_reason(Random& r) {  // so far that float's squares overflow
  const QuadBezier curve = random_curve(r);
  return {curve, r.magnitude(6, 37) * r.direction()};
}

BezierCase times(const BezierCase& k, double scale, double shift) {
  const auto moved = [&](glm::dvec2 p) { return p * scale + shift; };
  return {{moved(k.curve.p0), moved(k.curve.p1), moved(k.curve.p2)}, moved(k.p)};
}

BezierCase large_offset(Random& r) {
  return times(random_case(r), 1, 1e4);
}
BezierCase tiny(Random& r) {
  return times(random_case(r), 1e-6, 0);
}
BezierCase any_scale(Random& r) {
  const double scale = std::exp2(std::floor(r.between(-100, 100)));
  return times(r.chance(0.5) ? random_case(r) : evolute(r), scale, 0);
}

/// Cases reported against solvers in public, and the worst found in them by this laboratory.
BezierCase reported(Random& r) {
  static const std::array<QuadBezier, 12> kCurves{{
      {{-1, 0}, {0, 0}, {1, 0}},                // a line raised to a quadratic
      {{58, 173}, {110.5, 138.5}, {163, 104}},  // straight
      {{158.125, 225.5}, {157.5, 225.5}, {156.875, 225.5}},
      {{335.43211, 69.71516199999999}, {335.33051, 69.816762}, {335.27971, 69.86756199999999}},
      {{46, 125}, {45.8, 124.6}, {45.7, 124.4}},
      {{-30, 0}, {105, 10}, {240, 0}},
      {{-30, 0}, {105, 34}, {240, 0}},
      {{500, 300}, {425, 325}, {350, 350}},
      {{10, 10}, {10, 10}, {20, 20}},
      {{0, 0}, {0.5, -1.00332568e-12}, {1, 0}},
      {{0.531720161, 0.238497466}, {0.62581563, 0.862796307}, {0.545428216, 0.329644412}},
      {{0.0830078125, 0.0830078125}, {-0.446777344, -0.446777344}, {0.0922851562, 0.0922851562}},
  }};
  const QuadBezier& c = kCurves[r.bits() % kCurves.size()];
  const glm::dvec2 mid = (c.p0 + c.p1 + c.p2) / 3.0;
  const double size = std::max(glm::distance(c.p0, c.p2), glm::distance(c.p0, c.p1));
  const auto step = [&] { return std::floor(r.between(-10, 11)); };
  if (r.chance(0.3)) return {c, point(c, r.unit())};
  const double x = step();
  return {c, mid + size * glm::dvec2(0.17 * x, 0.13 * step())};
}

template <BezierCase (*draw)(Random&)>
Case drawn(Random& r) {
  return draw(r);
}

}  // namespace

std::vector<Family> bezier_families() {
  return {
      {"random", drawn<random_case>},
      {"on curve", drawn<on_curve>, true, false},
      {"near curve", drawn<near_curve>, true, false},
      {"near an end", drawn<near_an_end>, true, false},
      {"evolute", drawn<evolute>, true, false},
      {"evolute cusp", drawn<evolute_cusp>, true, false},
      {"axis", drawn<on_axis>, true, false},
      {"collinear", drawn<collinear>, true, false},
      {"near collinear", drawn<near_collinear>, true, false},
      {"straight from afar", drawn<straight_from_afar>},
      {"folded", drawn<folded>, true, false},
      {"p0 = p1", drawn<first_two_equal>},
      {"p1 = p2", drawn<last_two_equal>},
      {"p0 = p2", drawn<ends_equal>},
      {"all equal", drawn<all_equal>},
      {"nearly equal", drawn<nearly_equal>},
      {"far", drawn<far_away>},
      {"beyond reason", drawn<beyond_reason>},
      {"offset 1e4", drawn<large_offset>, true, false},
      {"tiny 1e-6", drawn<tiny>},
      {"any scale", drawn<any_scale>, true, false},
      {"reported", drawn<reported>, true, false},
      {"near collinear (double)", drawn<near_collinear>, false, false},
      {"evolute (double)", drawn<evolute>, false, false},
      {"folded (double)", drawn<folded>, false, false},
  };
}

}  // namespace mien::accuracy
