#include <mien/lib/math/norm.h>
#include <mien/lib/math/quartic.h>
#include <mien/sdf/shape/band.h>
#include <mien/sdf/shape/parabola_side.h>
#include "segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Whether p is inside, or outside by no more than the rounding of its own coordinates.
bool belongs(const ParabolaSide& side, glm::dvec2 p) {
  const glm::dvec2 q = p - side.vertex;
  const double v = glm::dot(q, side.axis), u = cross(side.axis, q);
  if (v >= side.bend * u * u) return true;
  const double size = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y);
  return distance(side, p) <= 0x1p-48 * size;
}

/// The distance from p to the part of `side`'s outline that lies in `other`, if it has a foot
/// there.
double to_surviving_feet(const ParabolaSide& side, const ParabolaSide& other, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  const Roots u = feet(side, p);
  for (int i = 0; i < u.count; ++i) {
    const glm::dvec2 foot = point(side, u.x[i]);
    const double d = norm(foot - p);
    if (d < nearest && belongs(other, foot)) nearest = d;
  }
  return nearest;
}

}  // namespace

// With P(s) = the lower outline's point at s, the upper side's formula dot(q, axis) −
// bend·cross(axis, q)² is a quartic in s (a quadratic if the axes are parallel); its roots are the
// corners.
BandCorners corners(const Band& band) {
  const ParabolaSide &a = band.lower, &b = band.upper;
  const glm::dvec2 from = a.vertex - b.vertex, left{-a.axis.y, a.axis.x};
  const double same = glm::dot(a.axis, b.axis);
  const double d0 = glm::dot(from, b.axis), d1 = glm::dot(left, b.axis), d2 = a.bend * same;
  const double c0 = cross(b.axis, from), c1 = same, c2 = a.bend * cross(b.axis, a.axis);
  const QuarticRoots s = solve_quartic(-b.bend * c2 * c2, -2.0 * b.bend * c1 * c2,
                                       d2 - b.bend * (c1 * c1 + 2.0 * c0 * c2),
                                       d1 - 2.0 * b.bend * c0 * c1, d0 - b.bend * c0 * c0);
  BandCorners found;
  for (int i = 0; i < s.count; ++i) {
    const glm::dvec2 corner = point(a, s.x[i]);
    if (std::isfinite(corner.x) && std::isfinite(corner.y)) found.point[found.count++] = corner;
  }
  return found;
}

// Inside, the distance is that to the nearer outline: the complement is a union, so max is exact.
// Outside, the nearest point of the band is a foot on an outline, inside the other side, or a
// corner. If the nearest foot on the side that is farther away survives, no other can be nearer. An
// empty band has neither feet nor corners; then max(lower, upper) is positive everywhere and
// 1-Lipschitz.
double distance(const Band& band, glm::dvec2 p) {
  const NearestOnParabola lower = nearest(band.lower, p), upper = nearest(band.upper, p);
  const double bound = std::max(lower.distance, upper.distance);
  if (!(bound > 0.0) || !std::isfinite(bound)) return outside_if_nan(bound);
  const bool by_lower = lower.distance >= upper.distance;
  const ParabolaSide& other = by_lower ? band.upper : band.lower;
  if (belongs(other, by_lower ? lower.point : upper.point)) return bound;
  double nearest_left = std::min(to_surviving_feet(band.lower, band.upper, p),
                                 to_surviving_feet(band.upper, band.lower, p));
  const BandCorners corner = corners(band);
  for (int i = 0; i < corner.count; ++i)
    nearest_left = std::min(nearest_left, norm(corner.point[i] - p));
  return std::isfinite(nearest_left) ? std::max(bound, nearest_left) : bound;
}

}  // namespace mien
