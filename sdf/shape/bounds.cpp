// bounds() of every shape. Boxes are as tight as the closed form allows and never smaller than the
// inside: where rounding could matter a slack of a few units in the last place is added.

#include <mien/parabola_side.h>
#include <mien/quad_bezier_distance.h>
#include "sdf/shape/curve/band.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Box2 kEverywhere{glm::dvec2(-kInfinity), glm::dvec2(kInfinity)};

double largest(glm::dvec2 v) {
  return std::max(std::abs(v.x), std::abs(v.y));
}

/// A box around `center`, `reach` to either side, and the rounding of both.
Box2 box_about(glm::dvec2 center, glm::dvec2 reach) {
  const double slack = 0x1p-50 * (largest(center) + largest(reach));
  return {center - reach - slack, center + reach + slack};
}

Box2 bounds_of(const HalfPlane& s) {
  Box2 box = kEverywhere;
  for (int i : {0, 1}) {
    if (s.normal[1 - i] != 0.0) continue;
    if (s.normal[i] > 0.0) box.hi[i] = s.offset / s.normal[i];
    if (s.normal[i] < 0.0) box.lo[i] = s.offset / s.normal[i];
  }
  return box;
}

/// The outline's farthest u against the direction of coordinate i, where a bend > 0 has one: the
/// slope of u·left + bend u²·axis vanishes.
double extreme_u(const ParabolaSide& s, int i) {
  const double left = i == 0 ? -s.axis.y : s.axis.x;
  return -left / (2.0 * s.bend * s.axis[i]);
}

Box2 bounds_of(const ParabolaSide& s) {
  if (s.bend < 0.0) return kEverywhere;
  if (s.bend == 0.0) return bounds_of(HalfPlane{-s.axis, -glm::dot(s.axis, s.vertex)});
  Box2 box = kEverywhere;
  for (int i : {0, 1}) {
    if (s.axis[i] == 0.0) continue;
    const double end = point(s, extreme_u(s, i))[i];
    const double slack = 0x1p-48 * (std::abs(end) + largest(s.vertex));
    if (!std::isfinite(end)) continue;
    if (s.axis[i] > 0.0) box.lo[i] = end - slack;
    if (s.axis[i] < 0.0) box.hi[i] = end + slack;
  }
  return box;
}

/// Whether both sides together leave no way to infinity, by a safe margin in the angle between the
/// axes.
bool closes(const Band& s) {
  const double dot = glm::dot(s.lower.axis, s.upper.axis);
  const double cross = s.lower.axis.x * s.upper.axis.y - s.lower.axis.y * s.upper.axis.x;
  if (s.lower.bend > 0.0 && s.upper.bend > 0.0) return dot < 0.0 || std::abs(cross) > 1e-3;
  return dot < 0.0 && cross == 0.0 && s.lower.bend + s.upper.bend > 0.0;
}

/// Extremes of a closed band: its corners and the turning points of its outlines.
Box2 bounds_of(const Band& s) {
  const Box2 sides = common(bounds_of(s.lower), bounds_of(s.upper));
  const BandCorners corner = corners(s);
  if (!closes(s) || corner.count == 0) return sides;
  Box2 box;
  for (int i = 0; i < corner.count; ++i) box = around(box, corner.point[i]);
  for (const ParabolaSide* side : {&s.lower, &s.upper})
    for (int i : {0, 1}) {
      if (side->bend == 0.0 || side->axis[i] == 0.0) continue;
      const glm::dvec2 turn = point(*side, extreme_u(*side, i));
      if (std::isfinite(turn.x) && std::isfinite(turn.y) &&
          distance(s, turn) <= 1e-9 * largest(turn))
        box = around(box, turn);
    }
  const double size = std::max(
      {largest(box.lo), largest(box.hi), largest(s.lower.vertex), largest(s.upper.vertex)});
  return common(sides, grown(box, 0x1p-40 * size));
}

Box2 bounds_of(const Disc& s) {
  return box_about(s.center, glm::dvec2(s.radius));
}

Box2 bounds_of(const CutDisc& s) {
  Box2 box = box_about(s.center, glm::dvec2(s.radius));
  for (int i : {0, 1}) {  // exact chords only where they run along the box
    if (s.up[1 - i] != 0.0) continue;
    const double up = std::min(s.upper, 1.0) * s.radius, down = std::min(s.lower, 1.0) * s.radius;
    const double slack = 0x1p-50 * (std::abs(s.center[i]) + s.radius);
    box.lo[i] = s.center[i] - (s.up[i] > 0.0 ? down : up) - slack;
    box.hi[i] = s.center[i] + (s.up[i] > 0.0 ? up : down) + slack;
  }
  return box;
}

Box2 bounds_of(const Ellipse& s) {
  const glm::dvec2 a = s.radii.x * s.axis, b = s.radii.y * s.axis;
  return box_about(s.center, {std::hypot(a.x, b.y), std::hypot(a.y, b.x)});
}

Box2 bounds_of(const Triangle& s) {
  return around(around(around(Box2{}, s.a), s.b), s.c);
}

Box2 wider(const Box2& box, double by) {
  return grown(box, by + 0x1p-51 * (by + std::max(largest(box.lo), largest(box.hi))));
}

Box2 bounds_of(const Line& s) {
  return wider(around(around(Box2{}, s.a), s.b), s.half_width);
}

Box2 bounds_of(const Polyline& s) {
  Box2 box;
  for (const glm::dvec2 p : s.points) box = around(box, p);
  return box.empty() ? box : wider(box, s.half_width);
}

Box2 bounds_of(const QuadStroke& s) {
  return wider(bounds(s.spine), s.half_width);
}

/// x(t) ± w(t) are quadratic Béziers of their own.
Box2 bounds_of(const TaperedStroke& s) {
  const double* w = s.half_width;
  const QuadBezier& c = s.spine;
  const Box2 low = bounds(QuadBezier{c.p0 - w[0], c.p1 - w[1], c.p2 - w[2]});
  const Box2 high = bounds(QuadBezier{c.p0 + w[0], c.p1 + w[1], c.p2 + w[2]});
  return wider(around(low, high), 0.0);
}

Box2 bounds_of(const Path& s) {
  Box2 box;
  for (const Path::Loop& loop : s.loops)
    for (const QuadBezier& side : loop.sides) box = around(box, bounds(side));
  return box;
}

}  // namespace

Box2 bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return bounds_of(s); }, shape);
}

}  // namespace mien
