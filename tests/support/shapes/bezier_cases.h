#pragma once
// Families of points and quadratic Bézier curves, most of them nasty.

#include <mien/quad_bezier.h>
#include "lib/math/norm.h"

#include <cmath>
#include <vector>

#include "tests/support/exact/real128.h"
#include "tests/support/random/random.h"

namespace mien::test {

struct BezierCase {
  QuadBezier curve;
  glm::dvec2 p;
};

enum class BezierFamily {
  random,
  on_curve,
  near_curve,
  evolute,
  evolute_cusp,
  axis,
  collinear,
  nearly_collinear,
  first_two_equal,
  last_two_equal,
  ends_equal,
  all_equal,
  far,
  offset,
  tiny,
  huge,
  closed_almost,
  count
};

inline glm::dvec2 on(const QuadBezier& c, double t) {
  const double s = 1 - t;
  return s * s * c.p0 + 2 * s * t * c.p1 + t * t * c.p2;
}

/// The centre of curvature at t.
inline glm::dvec2 evolute(const QuadBezier& c, double t) {
  const glm::dvec2 v = tangent(c, t), b = bend(c);
  const double turn = v.x * b.y - v.y * b.x, r = (v.x * v.x + v.y * v.y) / turn;
  return on(c, t) + r * glm::dvec2(-v.y, v.x);
}

/// The parameter of the parabola's vertex.
inline double vertex(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  return -(a.x * b.x + a.y * b.y) / (b.x * b.x + b.y * b.y);
}

inline BezierCase bezier_case(BezierFamily family, Random& r) {
  QuadBezier c{r.point(0, 1), r.point(0, 1), r.point(0, 1)};
  glm::dvec2 p = r.point(0, 1);
  const auto off = [&](double lo, double hi) {
    return r.chance(0.25) ? glm::dvec2(0) : r.size(lo, hi) * r.direction();
  };
  switch (family) {
    case BezierFamily::on_curve:
      p = on(c, r.unit());
      break;
    case BezierFamily::near_curve:
      p = on(c, r.unit()) + off(-16, -2);
      break;
    case BezierFamily::evolute:
      p = evolute(c, r.unit()) + off(-16, -2);
      break;
    case BezierFamily::evolute_cusp:
      p = evolute(c, vertex(c)) + off(-16, -2);
      break;
    case BezierFamily::axis: {
      const glm::dvec2 b = bend(c);
      p = on(c, vertex(c)) + r.between(-1, 1) * b + off(-16, -2);
      break;
    }
    case BezierFamily::collinear: {  // exactly: small multiples of one vector
      const glm::dvec2 v = 0x1p-12 * glm::dvec2(r.below(7) - 3, r.below(7) - 3);
      c = {double(r.below(4096)) * v, double(r.below(4096)) * v, double(r.below(4096)) * v};
      if (r.chance(0.3)) p = on(c, r.unit());
      break;
    }
    case BezierFamily::nearly_collinear: {
      const glm::dvec2 chord = c.p2 - c.p0;
      const double along = r.chance(0.5) ? 0.5 + r.sign() * r.size(-8, -1) : r.between(-1, 2);
      c.p1 = c.p0 + along * chord + r.sign() * r.size(-16, -3) * glm::dvec2(-chord.y, chord.x);
      if (r.chance(0.3)) p = on(c, r.unit()) + off(-16, -3);
      break;
    }
    case BezierFamily::first_two_equal:
      c.p1 = c.p0;
      break;
    case BezierFamily::last_two_equal:
      c.p1 = c.p2;
      break;
    case BezierFamily::ends_equal:
      c.p2 = c.p0;
      break;
    case BezierFamily::all_equal:
      c.p1 = c.p2 = c.p0;
      break;
    case BezierFamily::closed_almost:
      c.p2 = c.p0 + r.size(-14, -2) * r.direction();
      break;
    case BezierFamily::far:
      p = r.size(3, 12) * r.direction();
      break;
    case BezierFamily::offset: {
      const glm::dvec2 by = r.size(2, 8) * r.direction();
      c = {c.p0 + by, c.p1 + by, c.p2 + by};
      p += by;
      break;
    }
    case BezierFamily::tiny:
    case BezierFamily::huge: {
      const double k = family == BezierFamily::tiny ? r.size(-140, -6) : r.size(6, 140);
      c = {k * c.p0, k * c.p1, k * c.p2};
      p *= k;
      break;
    }
    default:
      break;
  }
  if (!(norm(p) < 1e160)) p = {0.5, 0.5};  // an evolute may run off
  return {c, p};
}

/// Cases that other solvers got wrong, with the distance. Their numbers are floats.
struct BezierFixture {
  BezierCase at;
  double distance;
};
inline const std::vector<BezierFixture> kBezierFixtures = {
    {{{{0, 0}, {0.5f, -1.00332568e-12f}, {1, 0}}, {0.174046248f, 5.794708e-08f}}, 5.794708e-08},
    {{{{0.531720161f, 0.238497466f}, {0.62581563f, 0.862796307f}, {0.545428216f, 0.329644412f}},
      {0.582464159f, 0.575228035f}},
     1.0798e-08},
    {{{{0.0830078125f, 0.0830078125f},
       {-0.446777344f, -0.446777344f},
       {0.0922851562f, 0.0922851562f}},
      {-0.179585561f, -0.179585561f}},
     2.599e-10},
};

/// The distance, by every root of the cubic and both ends.
inline Real exact_distance(const QuadBezier& c, glm::dvec2 p,
                           std::vector<Real>* stationary = nullptr) {
  const Real2 p0{c.p0.x, c.p0.y}, p1{c.p1.x, c.p1.y}, p2{c.p2.x, c.p2.y}, P{p.x, p.y};
  const Real2 q = p0 - P, a = p1 - p0, b = p2 - p1 - a;
  const Polynomial slope{dot(q, a), 2 * dot(a, a) + dot(q, b), 3 * dot(a, b), dot(b, b)};
  std::vector<Real> t = roots_in(slope, 0, 1);
  if (stationary) *stationary = t;
  t.push_back(0);
  t.push_back(1);
  Real best = -1;
  for (const Real u : t) {
    const Real2 d = q + u * (Real(2) * a + u * b);
    const Real squared = dot(d, d);
    if (best < 0 || squared < best) best = squared;
  }
  return sqrt(best);
}

/// The largest distance from p to a control point.
inline double reach(const QuadBezier& c, glm::dvec2 p) {
  return std::max({norm(c.p0 - p), norm(c.p1 - p), norm(c.p2 - p)});
}

}  // namespace mien::test
