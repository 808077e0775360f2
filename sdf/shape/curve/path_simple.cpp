#include "sdf/shape/curve/path.h"

#include "path_sides_private.h"

#include <mien/box2.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

namespace mien {
namespace {

/// Sides whose boxes overlap are compared; a path of more sides than this is taken as overlapping.
constexpr std::size_t kMostSides = 20'000;
constexpr std::size_t kFewSides = 256;
/// Comparisons for each side: a path that needs more is taken as overlapping.
constexpr std::size_t kMostCompared = 64;

using Hull =
    std::array<glm::dvec2, 3>;  // of a side: its control points; of a straight one its ends

bool is_line(const Hull& hull) {
  return hull[0] == hull[1];
}

/// Whether some line keeps a strictly on its positive side, except for points it shares with b, and
/// b on the line or its negative side: then the hulls meet in shared points only.
/// Heights count from `joint`, so that one that both share has height 0 without rounding.
bool parts(glm::dvec2 normal, const Hull& a, const Hull& b, glm::dvec2 joint) {
  const auto height_of = [&](glm::dvec2 p) { return glm::dot(normal, p - joint); };
  double top = height_of(b[0]);
  for (const glm::dvec2 q : b) top = std::max(top, height_of(q));
  for (const glm::dvec2 p : a) {
    const bool shared = p == b[0] || p == b[2];
    const double height = height_of(p);
    if (shared ? height < top : height <= top) return false;
  }
  return true;
}

bool apart(const Hull& a, const Hull& b) {
  if (is_line(a) && is_line(b) && a[0] == b[2] && a[2] == b[0]) return false;  // there and back
  const glm::dvec2 joint = a[0] == b[0] || a[0] == b[2] ? a[0] : a[2];
  for (const Hull* hull : {&a, &b})
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 along = (*hull)[(i + 1) % 3] - (*hull)[i], normal{-along.y, along.x};
      for (const glm::dvec2 n : {normal, -normal, along, -along})
        if (parts(n, a, b, joint) || parts(n, b, a, joint)) return true;
    }
  return false;
}

struct Extent {
  Box2 box;
  std::size_t hull;
};

/// Whether no two hulls meet but in joints. Sorted along x, only neighbours in x can.
bool all_apart(std::span<const Hull> hulls) {
  std::array<Extent, kFewSides> few;  // most paths have no more, and then nothing is allocated
  std::vector<Extent> many(hulls.size() > kFewSides ? hulls.size() : 0);
  const std::span<Extent> extents(hulls.size() > kFewSides ? many.data() : few.data(),
                                  hulls.size());
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    extents[i] = {{}, i};
    for (const glm::dvec2 p : hulls[i]) extents[i].box = around(extents[i].box, p);
  }
  std::sort(extents.begin(), extents.end(),
            [](const Extent& a, const Extent& b) { return a.box.lo.x < b.box.lo.x; });
  std::size_t compared = 0;
  for (std::size_t i = 0; i < extents.size(); ++i)
    for (std::size_t k = i + 1; k < extents.size(); ++k) {
      const Box2 &a = extents[i].box, &b = extents[k].box;
      if (b.lo.x > a.hi.x) break;
      if (b.lo.y > a.hi.y || b.hi.y < a.lo.y) continue;
      if (hulls.size() > kFewSides && ++compared > kMostCompared * hulls.size()) return false;
      if (!apart(hulls[extents[i].hull], hulls[extents[k].hull])) return false;
    }
  return true;
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
    for_each_side(loop, [&](const QuadBezier& c) {
      hulls[next++] = {c.p0, is_straight(c) ? c.p0 : c.p1, c.p2};
    });
  for (const Hull& hull : hulls)
    if (hull[0] == hull[2]) return false;  // there and back
  if (!all_apart(hulls)) return false;
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
