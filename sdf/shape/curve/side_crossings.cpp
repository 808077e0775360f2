#include "side_crossings_private.h"

#include "path_sides_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

double turn(glm::dvec2 u, glm::dvec2 v) {
  return u.x * v.y - u.y * v.x;
}

/// Coefficients on [0, 1] in Bernstein's form.
using Quadratic = std::array<double, 3>;
using Quartic = std::array<double, 5>;

Quartic product(const Quadratic& u, const Quadratic& v) {
  return {u[0] * v[0], 0.5 * (u[0] * v[1] + u[1] * v[0]),
          (u[0] * v[2] + 4.0 * u[1] * v[1] + u[2] * v[0]) / 6.0, 0.5 * (u[1] * v[2] + u[2] * v[1]),
          u[2] * v[2]};
}

/// A quadratic as a quartic.
Quartic raised(const Quadratic& u) {
  return product(u, {1.0, 1.0, 1.0});
}

/// How far a side is from another one, along itself, and what is only rounding or tolerance of that.
struct Form {
  Quartic f;
  double noise;
};

Form seen_from_line(const QuadBezier& line, const QuadBezier& c, double tolerance) {
  const glm::dvec2 way = line.p2 - line.p0;
  const auto off = [&](glm::dvec2 p) { return turn(way, p - line.p0); };
  return {raised({off(c.p0), off(c.p1), off(c.p2)}), glm::length(way) * tolerance};
}

/// With q = p − p0 = (u a + v b) / turn(a, b), where the parabola is p0 + 2t a + t² b, a point is on it if
/// u² = 4 v turn(a, b).
Form seen_from_parabola(const QuadBezier& from, const QuadBezier& c, double tolerance) {
  const glm::dvec2 a = from.p1 - from.p0, b = (from.p2 - from.p1) - a;
  const double area = turn(a, b);
  Quadratic u, v;
  int i = 0;
  for (const glm::dvec2 p : {c.p0, c.p1, c.p2})
    u[i] = turn(p - from.p0, b), v[i++] = turn(a, p - from.p0);
  const Quartic squared = product(u, u), beside = raised(v);
  Form form{{}, 0.0};
  for (int k = 0; k < 5; ++k) form.f[k] = squared[k] - 4.0 * area * beside[k];
  const double most = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
  form.noise = (2.0 * most * glm::length(b) + 4.0 * std::abs(area) * glm::length(a)) * tolerance;
  return form;
}

/// Both halves of a polynomial, by de Casteljau's scheme.
void halve(const Quartic& f, Quartic& left, Quartic& right) {
  Quartic row = f;
  for (int k = 0; k < 5; ++k) {
    left[k] = row[0], right[4 - k] = row[4 - k];
    for (int i = 0; i + k < 4; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
}

bool one_sign(const Quartic& f) {
  return std::all_of(f.begin(), f.end(), [](double v) { return v > 0.0; }) ||
         std::all_of(f.begin(), f.end(), [](double v) { return v < 0.0; });
}

/// The parameter of a side's point that is nearest to p, if p lies on it but for a little.
double parameter_of(const QuadBezier& c, glm::dvec2 p) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  if (is_straight(c)) return glm::dot(p - c.p0, a) / (2.0 * glm::dot(a, a));
  return turn(p - c.p0, b) / (2.0 * turn(a, b));
}

/// The point on both sides near those at parameters `at`, by Newton's method: false if there is none.
bool refine(const QuadBezier& a, const QuadBezier& b, double tolerance, SideCrossing& at) {
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec2 gap = point(b, at.b) - point(a, at.a), u = tangent(a, at.a),
                     v = tangent(b, at.b);
    const double area = turn(u, v);
    if (!(std::abs(area) > 0.0)) break;
    const double by_a = turn(gap, v) / area, by_b = turn(gap, u) / area;
    at.a = std::clamp(at.a + by_a, 0.0, 1.0), at.b = std::clamp(at.b + by_b, 0.0, 1.0);
    if (std::abs(by_a) + std::abs(by_b) < 0x1p-50) break;
  }
  return glm::distance(point(a, at.a), point(b, at.b)) <= tolerance;
}

void add(SideCrossings& to, const SideCrossing& crossing) {
  constexpr double kSame = 1e-9;
  for (int i = 0; i < to.count; ++i)
    if (std::abs(to.at[std::size_t(i)].a - crossing.a) < kSame &&
        std::abs(to.at[std::size_t(i)].b - crossing.b) < kSame)
      return;
  if (to.count < int(to.at.size())) to.at[std::size_t(to.count++)] = crossing;
}

SideCrossings of_lines(const QuadBezier& a, const QuadBezier& b) {
  const glm::dvec2 u = a.p2 - a.p0, v = b.p2 - b.p0, between = b.p0 - a.p0;
  const double area = turn(u, v);
  if (!(std::abs(area) > 0x1p-50 * glm::length(u) * glm::length(v))) return {};
  const SideCrossing at{turn(between, v) / area, turn(between, u) / area};
  SideCrossings made;
  if (at.a >= 0.0 && at.a <= 1.0 && at.b >= 0.0 && at.b <= 1.0) add(made, at);
  return made;
}

/// `b`, seen from `a`.
SideCrossings of_parabolas(const QuadBezier& a, const QuadBezier& b, double tolerance) {
  constexpr int kHalvings = 12, kMostWaiting = 64;
  struct Interval {
    Quartic f;
    double from, to;
    int halvings;
  };
  const Form form =
      is_straight(a) ? seen_from_line(a, b, tolerance) : seen_from_parabola(a, b, tolerance);
  SideCrossings made;
  if (one_sign(form.f) ||
      std::all_of(form.f.begin(), form.f.end(),
                  [&](double v) { return std::abs(v) <= form.noise; }))
    return made;
  std::array<Interval, kMostWaiting> waiting;
  int count = 0;
  waiting[std::size_t(count++)] = {form.f, 0.0, 1.0, 0};
  while (count > 0) {
    const Interval now = waiting[std::size_t(--count)];
    if (one_sign(now.f)) continue;
    const double middle = 0.5 * (now.from + now.to);
    if (now.halvings == kHalvings) {
      SideCrossing at{std::clamp(parameter_of(a, point(b, middle)), 0.0, 1.0), middle};
      if (refine(a, b, tolerance, at)) add(made, at);
      continue;
    }
    Interval left{{}, now.from, middle, now.halvings + 1}, right{{}, middle, now.to, left.halvings};
    halve(now.f, left.f, right.f);
    waiting[std::size_t(count++)] = right, waiting[std::size_t(count++)] = left;
  }
  return made;
}

}  // namespace

SideCrossings side_crossings(const QuadBezier& a, const QuadBezier& b, double tolerance) {
  if (is_straight(a) && is_straight(b)) return of_lines(a, b);
  if (is_straight(b)) {
    SideCrossings made = of_parabolas(b, a, tolerance);
    for (int i = 0; i < made.count; ++i)
      std::swap(made.at[std::size_t(i)].a, made.at[std::size_t(i)].b);
    return made;
  }
  return of_parabolas(a, b, tolerance);
}

}  // namespace mien
