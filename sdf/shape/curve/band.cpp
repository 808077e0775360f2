#include "sdf/shape/curve/band.h"
#include <mien/parabola_side.h>
#include "lib/math/norm.h"
#include "lib/math/quartic.h"
#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// How far inside p is by the side's definition, and the size of its rounding.
struct Inside {
  double value, noise;
};

Inside inside(const ParabolaSide& side, glm::dvec2 p) {
  const glm::dvec2 q = p - side.vertex;
  const double v = glm::dot(q, side.axis), u = cross(side.axis, q), bow = side.bend * u * u;
  const double size = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y);
  return {v - bow, 0x1p-45 * (size + std::abs(bow) + std::abs(side.bend * u) * size)};
}

/// A side's outline cut at the corners into pieces, each of which is inside the other side or not. That is decided
/// once for each piece, far from its ends, so that feet near a corner are treated consistently.
struct Pieces {
  int cuts;
  std::array<double, 4> cut{};  ///< ascending u
  std::array<bool, 5> survives{};

  Pieces(const ParabolaSide& side, const ParabolaSide& other, const BandCorners& corner)
      : cuts(corner.count) {
    for (int i = 0; i < cuts; ++i) cut[i] = cross(side.axis, corner.point[i] - side.vertex);
    std::sort(cut.begin(), cut.begin() + cuts);
    double far = norm(side.vertex - other.vertex);
    if (side.bend != 0.0) far = std::max(far, std::abs(1.0 / side.bend));
    if (cuts > 0) far = std::max({far, std::abs(cut[0]), std::abs(cut[cuts - 1])});
    if (!(far > 0.0 && far < 1e100)) far = 1.0;
    for (int i = 0; i <= cuts; ++i) {
      double u = 0.0;
      if (cuts > 0) {
        if (i == 0)
          u = cut[0] - far;
        else if (i == cuts)
          u = cut[cuts - 1] + far;
        else
          u = 0.5 * (cut[i - 1] + cut[i]);
      }
      survives[i] = inside(other, point(side, u)).value >= 0.0;
    }
  }

  bool contains(double u) const {
    int i = 0;
    while (i < cuts && u > cut[i]) ++i;
    return survives[i] || (i < cuts && u == cut[i] && survives[i + 1]);
  }
};

/// The distance from p to the surviving feet on a side's outline; +infinity without any.
double to_feet(const ParabolaSide& side, const Pieces& pieces, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  const Roots u = feet(side, p);
  for (int i = 0; i < u.count; ++i)
    if (pieces.contains(u.x[i])) nearest = std::min(nearest, norm(point(side, u.x[i]) - p));
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

bool is_empty(const Band& band) {
  const BandCorners corner = corners(band);
  return corner.count == 0 && !Pieces(band.lower, band.upper, corner).survives[0] &&
         !Pieces(band.upper, band.lower, corner).survives[0];
}

// Inside, the distance is that to the nearer outline: the complement is a union, so max is exact.
// Outside, the nearest point of the band is a surviving foot or a corner. If the nearest foot on
// the side that is farther away is well inside the other side, no other can be nearer. An empty
// band has neither feet nor corners; then max(lower, upper) is positive everywhere and 1-Lipschitz.
double distance(const Band& band, glm::dvec2 p) {
  const NearestOnParabola lower = nearest(band.lower, p), upper = nearest(band.upper, p);
  const double bound = std::max(lower.distance, upper.distance);
  if (!(bound > 0.0) || !std::isfinite(bound)) return outside_if_nan(bound);
  const bool by_lower = lower.distance >= upper.distance;
  const Inside foot =
      inside(by_lower ? band.upper : band.lower, by_lower ? lower.point : upper.point);
  if (foot.value > foot.noise) return bound;
  const BandCorners corner = corners(band);
  double nearest_left = std::min(to_feet(band.lower, Pieces(band.lower, band.upper, corner), p),
                                 to_feet(band.upper, Pieces(band.upper, band.lower, corner), p));
  for (int i = 0; i < corner.count; ++i)
    nearest_left = std::min(nearest_left, norm(corner.point[i] - p));
  return std::isfinite(nearest_left) ? std::max(bound, nearest_left) : bound;
}

}  // namespace mien
