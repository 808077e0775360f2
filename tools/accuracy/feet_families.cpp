#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tools/accuracy/feet.h"

namespace mien::accuracy {
namespace {

QuadBezier any_curve(Random& r) {
  const glm::dvec2 p0 = r.point(), p1 = r.point();
  return {p0, p1, r.point()};
}
/// Exactly at `at` a quarter of the time, else off it by 1e-12 … 1e-2.
glm::dvec2 beside(Random& r, glm::dvec2 at) {
  return r.chance(0.25) ? at : at + r.magnitude(-12, -2) * r.direction();
}
glm::dvec2 left(glm::dvec2 v) {
  return {-v.y, v.x};
}

/// Curves one after the other; half of their joints are smooth.
std::vector<QuadBezier> some_chain(Random& r, bool closes) {
  std::vector<QuadBezier> chain{any_curve(r)};
  const int count = 2 + int(r.bits() % 4);
  for (int i = 1; i < count; ++i) {
    const QuadBezier& last = chain.back();
    QuadBezier next = any_curve(r);
    next.p0 = last.p2;
    if (r.chance(0.5)) next.p1 = last.p2 + r.between(0.2, 2) * (last.p2 - last.p1);
    chain.push_back(next);
  }
  if (closes) {
    chain.back().p2 = chain.front().p0;
    if (r.chance(0.5)) chain.back().p1 = 2.0 * chain.front().p0 - chain.front().p1;
  }
  return chain;
}

/// On the normal of a joint, on its corner's cone, or about the joint.
glm::dvec2 about_joint(Random& r, const QuadBezier& before, const QuadBezier& next) {
  const glm::dvec2 g = r.chance(0.5) ? tangent(before, 1) : tangent(next, 0);
  const glm::dvec2 n = glm::length(g) > 0 ? left(g) / glm::length(g) : glm::dvec2{1, 0};
  if (r.chance(0.2)) return beside(r, next.p0);
  return beside(r, next.p0 + r.sign() * r.magnitude(-3, 0.3) * n);
}

FeetCase joints(Random& r) {
  const auto chain = some_chain(r, r.chance(0.5));
  const size_t i = r.bits() % (chain.size() - 1);
  return {chain, r.chance(0.3) ? 2.0 * r.point() - 0.5 : about_joint(r, chain[i], chain[i + 1])};
}
FeetCase closed_chain(Random& r) {
  const auto chain = some_chain(r, true);
  const size_t i = r.bits() % chain.size();
  return {chain, r.chance(0.3)
                     ? 2.0 * r.point() - 0.5
                     : about_joint(r, chain[(i + chain.size() - 1) % chain.size()], chain[i])};
}

/// A curve and its mirror image, seen from about the mirror: two branches equally near.
FeetCase mirrored(Random& r) {
  const QuadBezier c = any_curve(r);
  const auto over = [](glm::dvec2 v) { return glm::dvec2{2 - v.x, v.y}; };
  return {std::vector<QuadBezier>{c, {over(c.p0), over(c.p1), over(c.p2)}},
          beside(r, {1, r.between(-1, 2)})};
}
/// The same curve twice, run backwards, or a part of it.
FeetCase coincident(Random& r) {
  const QuadBezier c = any_curve(r);
  const double t = r.between(0.2, 1);
  const glm::dvec2 at = point(c, t);
  const QuadBezier part{c.p0, c.p0 + t * (c.p1 - c.p0), at};
  return {std::vector<QuadBezier>{c, r.chance(0.3)   ? c
                                     : r.chance(0.5) ? reversed(c)
                                                     : part},
          2.0 * r.point() - 0.5};
}
FeetCase many_curves(Random& r) {
  std::vector<QuadBezier> curves;
  for (uint64_t i = 3 + r.bits() % 10; i > 0; --i) curves.push_back(any_curve(r));
  return {curves, 2.0 * r.point() - 0.5};
}
FeetCase polyline(Random& r) {
  std::vector<Line> lines;
  glm::dvec2 at = r.point();
  const double w = r.chance(0.5) ? 0 : 0.2 * r.unit();
  for (uint64_t i = 1 + r.bits() % 5; i > 0; --i) {
    const glm::dvec2 next = r.point();
    lines.push_back({at, next, w});
    at = r.chance(0.1) ? r.point() : next;
  }
  const Line& one = lines[r.bits() % lines.size()];
  const glm::dvec2 n = left(one.b - one.a);
  const std::array<glm::dvec2, 3> places{2.0 * r.point() - 0.5, one.a + r.between(-1, 1) * n,
                                         one.a + r.unit() * (one.b - one.a)};
  return {lines, beside(r, places[r.bits() % 3])};
}
/// Exactly axis-parallel squares and crosses, seen from their axes.
FeetCase square(Random& r) {
  const double w = r.chance(0.5) ? 0 : 0.25;
  const std::vector<Line> lines{
      {{0, 0}, {1, 0}, w}, {{1, 0}, {1, 1}, w}, {{1, 1}, {0, 1}, w}, {{0, 1}, {0, 0}, w}};
  const double x = std::floor(r.between(-8, 17)) / 8;
  return {lines, {x, r.chance(0.5) ? x : std::floor(r.between(-8, 17)) / 8}};
}

/// Half-widths that grow about as fast as the spine goes, or faster.
FeetCase outrun(Random& r) {
  const QuadBezier c = any_curve(r);
  const double length = glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1);
  TaperedStroke s{c, {0.1 * r.unit(), 0, 0}};
  s.half_width[1] = s.half_width[0] + 0.5 * length * r.between(0.6, 1.6);
  s.half_width[2] = std::max(0.0, s.half_width[1] + 0.5 * length * r.between(-1.6, 1.6));
  const double t = r.unit();
  const glm::dvec2 n = left(tangent(c, t));
  return {std::vector<TaperedStroke>{s},
          r.chance(0.5) ? 3.0 * r.point() - 1.0 : beside(r, point(c, t) + r.between(-1, 1) * n)};
}
FeetCase stroke_chain(Random& r) {
  std::vector<TaperedStroke> strokes;
  double w = 0.2 * r.unit();
  const auto chain = some_chain(r, r.chance(0.5));
  const double first = w;
  for (size_t i = 0; i < chain.size(); ++i) {
    const double middle = 0.2 * r.unit(), last = i + 1 == chain.size() ? first : 0.2 * r.unit();
    strokes.push_back({chain[i], {w, middle, last}});
    w = last;
  }
  const size_t i = r.bits() % (chain.size() - 1);
  return {strokes, r.chance(0.5) ? 2.0 * r.point() - 0.5 : about_joint(r, chain[i], chain[i + 1])};
}
/// Constant half-widths, and spines that are straight.
FeetCase plain_stroke(Random& r) {
  QuadBezier c = any_curve(r);
  if (r.chance(0.5)) c.p1 = 0.5 * (c.p0 + c.p2);
  const double w = 0.2 * r.unit(), end = r.chance(0.5) ? w : 0.2 * r.unit();
  return {std::vector<TaperedStroke>{{c, {w, 0.5 * (w + end), end}}}, 2.0 * r.point() - 0.5};
}

/// A family of distances, of one figure.
FeetFamily alone(const Family& family) {
  return {family.name, [draw = family.draw](Random& r) -> FeetCase {
            const Case k = draw(r);
            if (const auto* c = std::get_if<QuadBezier>(&k.figure))
              return {std::vector<QuadBezier>{*c}, k.p};
            if (const auto* s = std::get_if<TaperedStroke>(&k.figure))
              return {std::vector<TaperedStroke>{*s}, k.p};
            return {std::get<Ellipse>(k.figure), k.p};
          }};
}

}  // namespace

const std::vector<FeetFamily>& feet_families() {
  static const std::vector<FeetFamily> all = [] {
    std::vector<FeetFamily> list;
    for (const Family& family : families()) {
      const std::string& name = family.name;
      const bool is_kept = name.find("parabola") != 0 && name.find("cubic") != 0 &&
                           name.find("(double)") == std::string::npos;
      if (is_kept) list.push_back(alone(family));
    }
    const std::vector<FeetFamily> more{{"joints", joints},
                                       {"closed chain", closed_chain},
                                       {"mirrored", mirrored},
                                       {"coincident", coincident},
                                       {"many curves", many_curves},
                                       {"polyline", polyline},
                                       {"square", square},
                                       {"stroke, outrun", outrun},
                                       {"stroke chain", stroke_chain},
                                       {"plain stroke", plain_stroke}};
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

std::vector<FeetCase> feet_cases_of(const FeetFamily& family, size_t count, uint64_t seed) {
  uint64_t mixed = seed;
  for (const char c : family.name) mixed = (mixed ^ uint64_t(c)) * 0x100000001B3u;
  Random random(mixed);
  std::vector<FeetCase> cases;
  while (cases.size() < count) cases.push_back(family.draw(random));
  return cases;
}

}  // namespace mien::accuracy
