#include "side_crossings_private.h"

#include <mien/quad_bezier_distance.h>
#include "path_sides_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mien {
namespace {

double turn(glm::dvec2 u, glm::dvec2 v) {
  return u.x * v.y - u.y * v.x;
}

/// Coefficients on [0, 1] in Bernstein's form.
using Quadratic = std::array<double, 3>;
using BernsteinQuartic = std::array<double, 5>;

BernsteinQuartic product(const Quadratic& u, const Quadratic& v) {
  return {u[0] * v[0], 0.5 * (u[0] * v[1] + u[1] * v[0]),
          (u[0] * v[2] + 4.0 * u[1] * v[1] + u[2] * v[0]) / 6.0, 0.5 * (u[1] * v[2] + u[2] * v[1]),
          u[2] * v[2]};
}

/// A quadratic as a quartic.
BernsteinQuartic raised(const Quadratic& u) {
  return product(u, {1.0, 1.0, 1.0});
}

/// How far a side is from another one, along itself, and what is only rounding or tolerance of that.
struct Form {
  BernsteinQuartic f;
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
  const BernsteinQuartic squared = product(u, u), beside = raised(v);
  Form form{{}, 0.0};
  for (int k = 0; k < 5; ++k) form.f[k] = squared[k] - 4.0 * area * beside[k];
  const double most = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
  form.noise = (2.0 * most * glm::length(b) + 4.0 * std::abs(area) * glm::length(a)) * tolerance;
  return form;
}

/// Both halves of a polynomial, by de Casteljau's scheme.
void halve(const BernsteinQuartic& f, BernsteinQuartic& left, BernsteinQuartic& right) {
  BernsteinQuartic row = f;
  for (int k = 0; k < 5; ++k) {
    left[k] = row[0], right[4 - k] = row[4 - k];
    for (int i = 0; i + k < 4; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
}

/// How often the coefficients change their sign, and once more for each end that is a root: at least as often as there
/// are roots.
int most_roots(const BernsteinQuartic& f) {
  int changes = int(f.front() == 0.0) + int(f.back() == 0.0);
  double last = 0.0;
  for (const double v : f) {
    if (v == 0.0) continue;
    changes += last != 0.0 && (v < 0.0) != (last < 0.0);
    last = v;
  }
  return changes;
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

/// `b`, seen from `a`. Intervals are halved until one root at most is left in each, unless roots are nearly one.
SideCrossings of_parabolas(const QuadBezier& a, const QuadBezier& b, double tolerance) {
  constexpr int kHalvings = 12, kMostHalvings = 26;
  struct Interval {
    BernsteinQuartic f;
    double from, to;
    int halvings;
  };
  const Form form =
      is_straight(a) ? seen_from_line(a, b, tolerance) : seen_from_parabola(a, b, tolerance);
  SideCrossings made;
  if (std::all_of(form.f.begin(), form.f.end(),
                  [&](double v) { return std::abs(v) <= form.noise; }))
    return made;
  std::array<Interval, kMostHalvings + 2> waiting;
  std::size_t count = 0;
  waiting[count++] = {form.f, 0.0, 1.0, 0};
  while (count > 0) {
    const Interval now = waiting[--count];
    const int roots = most_roots(now.f);
    if (roots == 0) continue;
    const double middle = 0.5 * (now.from + now.to);
    if (now.halvings >= (roots == 1 ? kHalvings : kMostHalvings)) {
      SideCrossing at{nearest(a, point(b, middle)).t, middle};
      if (refine(a, b, tolerance, at)) add(made, at);
      continue;
    }
    Interval left{{}, now.from, middle, now.halvings + 1}, right{{}, middle, now.to, left.halvings};
    halve(now.f, left.f, right.f);
    waiting[count++] = right, waiting[count++] = left;
  }
  return made;
}

/// How far a side is from a line or from turning back on itself, whatever its size.
double roundness(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  return std::abs(turn(a, b)) / (glm::dot(a, a) + glm::dot(b, b));
}

}  // namespace

/// A line is a good place to see from; else the rounder one: on the other, which may turn back beside itself, parameters
/// are told apart.
SideCrossings side_crossings(const QuadBezier& a, const QuadBezier& b, double tolerance) {
  const bool line = is_straight(a);
  if (line && is_straight(b)) return of_lines(a, b);
  if (line || (!is_straight(b) && roundness(a) >= roundness(b)))
    return of_parabolas(a, b, tolerance);
  SideCrossings made = of_parabolas(b, a, tolerance);
  for (int i = 0; i < made.count; ++i)
    std::swap(made.at[std::size_t(i)].a, made.at[std::size_t(i)].b);
  return made;
}

}  // namespace mien
