#include "sdf/shape/curve/path.h"

#include "path_sides_private.h"

#include <array>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

namespace mien {
namespace {

/// Pairs of sides are compared one by one; a path of more sides than this is taken as overlapping.
constexpr std::size_t kMostSides = 2000;
constexpr std::size_t kFewSides = 256;

using Hull = std::array<glm::dvec2, 3>;  // of a side: its control points

/// Whether some line keeps a strictly on its positive side, except for points it shares with b, and
/// b on the line or its negative side: then the hulls meet in shared points only.
bool parts(glm::dvec2 normal, const Hull& a, const Hull& b) {
  double top = glm::dot(normal, b[0]);
  for (const glm::dvec2 q : b) top = std::max(top, glm::dot(normal, q));
  for (const glm::dvec2 p : a) {
    const bool shared = p == b[0] || p == b[2];
    const double height = glm::dot(normal, p);
    if (shared ? height < top : height <= top) return false;
  }
  return true;
}

bool apart(const Hull& a, const Hull& b) {
  for (const Hull* hull : {&a, &b})
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 along = (*hull)[(i + 1) % 3] - (*hull)[i], normal{-along.y, along.x};
      for (const glm::dvec2 n : {normal, -normal, along, -along})
        if (parts(n, a, b) || parts(n, b, a)) return true;
    }
  return false;
}

double twice_area(const Path::Loop& loop) {
  double area = 0.0;
  for_each_side(loop, [&](const QuadBezier& c) {
    const auto cross = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; };
    area += (2.0 * cross(c.p0, c.p1) + 2.0 * cross(c.p1, c.p2) + cross(c.p0, c.p2)) / 3.0;
  });
  return area;
}

}  // namespace

bool is_simple(const Path& path) {
  std::size_t count = 0;
  for (const Path::Loop& loop : path.loops)
    for_each_side(loop, [&](const QuadBezier&) { ++count; });
  if (count > kMostSides) return false;
  std::array<Hull, kFewSides> few;  // most paths have no more, and then nothing is allocated
  std::vector<Hull> many(count > kFewSides ? count : 0);
  const std::span<Hull> hulls(count > kFewSides ? many.data() : few.data(), count);
  std::size_t next = 0;
  for (const Path::Loop& loop : path.loops)
    for_each_side(loop, [&](const QuadBezier& c) { hulls[next++] = {c.p0, c.p1, c.p2}; });
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    if (hulls[i][0] == hulls[i][2]) return false;  // there and back
    for (std::size_t k = 0; k < i; ++k)
      if (!apart(hulls[i], hulls[k])) return false;
  }
  for (std::size_t i = 0; i < path.loops.size(); ++i) {
    if (path.loops[i].sides.empty()) continue;
    int outside = 0;
    for (std::size_t k = 0; k < path.loops.size(); ++k)
      if (k != i) outside += winding(path.loops[k], path.loops[i].sides[0].p0);
    const int inside = outside + (twice_area(path.loops[i]) > 0.0 ? 1 : -1);
    if (is_inside(path.rule, outside) == is_inside(path.rule, inside)) return false;
  }
  return true;
}

}  // namespace mien
