#include "tools/accuracy/families.h"

#include <cmath>
#include <numbers>

namespace mien::accuracy {
namespace {

/// Not inlined: GCC 12 drops the rounding if it makes one vector of two such calls (-O2, x86-64).
[[gnu::noinline]] double in_float(double x) {
  return double(float(x));
}
glm::dvec2 in_float(glm::dvec2 p) {
  return {in_float(p.x), in_float(p.y)};
}
QuadBezier in_float(const QuadBezier& c) {
  return {in_float(c.p0), in_float(c.p1), in_float(c.p2)};
}
Ellipse in_float(const Ellipse& e) {
  return {in_float(e.center), in_float(e.radii), e.axis};
}
ParabolaSide in_float(const ParabolaSide& s) {
  return {in_float(s.vertex), s.axis, in_float(s.bend)};
}
CubicBezier in_float(const CubicBezier& c) {
  return {in_float(c.p0), in_float(c.p1), in_float(c.p2), in_float(c.p3)};
}
TaperedStroke in_float(const TaperedStroke& s) {
  const double* w = s.half_width;
  return {in_float(s.spine), {in_float(w[0]), in_float(w[1]), in_float(w[2])}};
}

}  // namespace

double Random::magnitude(double lo, double hi) {
  return std::pow(10.0, between(lo, hi));
}

glm::dvec2 Random::direction() {
  const double angle = between(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list = bezier_families();
    for (const auto& more : {conic_families(), stroke_families()}) {
      list.insert(list.end(), more.begin(), more.end());
    }
    return list;
  }();
  return all;
}

Case in_floats(const Case& k) {
  return {std::visit([](const auto& figure) -> Figure { return in_float(figure); }, k.figure),
          in_float(k.p)};
}

std::vector<Case> cases_of(const Family& family, size_t count, uint64_t seed) {
  uint64_t mixed = seed;
  for (const char c : family.name) mixed = (mixed ^ uint64_t(c)) * 0x100000001B3u;
  Random random(mixed);
  std::vector<Case> cases;
  cases.reserve(count);
  while (cases.size() < count) {
    const Case k = family.draw(random);
    cases.push_back(family.float_exact ? in_floats(k) : k);
  }
  return cases;
}

}  // namespace mien::accuracy
