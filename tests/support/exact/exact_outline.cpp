#include "tests/support/exact/exact_outline.h"

#include <mien/quad_bezier_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/exact/real128.h"
#include "tests/support/shapes/winding_upwards.h"

namespace mien::test {
namespace {

struct Coefficients {
  Polynomial x, y;
};

Coefficients coefficients(const QuadBezier& c) {
  const auto of = [](double p0, double p1, double p2) {
    const Real a = Real(p1) - p0;
    return Polynomial{Real(p0), 2 * a, Real(p2) - p1 - a};
  };
  return {of(c.p0.x, c.p1.x, c.p2.x), of(c.p0.y, c.p1.y, c.p2.y)};
}

/// All sides, closed.
std::vector<QuadBezier> sides_of(const Path& path) {
  std::vector<QuadBezier> sides;
  for (const Path::Loop& loop : path.loops)
    for (std::size_t i = 0; i < loop.sides.size(); ++i) {
      const glm::dvec2 end = loop.sides[i].p2, next = loop.sides[(i + 1) % loop.sides.size()].p0;
      sides.push_back(loop.sides[i]);
      if (end != next) sides.push_back({end, 0.5 * (end + next), next});
    }
  return sides;
}

/// Zero where `c` meets the line or parabola of `other`, everywhere beyond its ends too: Sylvester's resultant.
Polynomial meeting(const QuadBezier& c, const QuadBezier& other) {
  const Coefficients at = coefficients(c), o = coefficients(other);
  const Polynomial x = at.x + Real(-1) * Polynomial{o.x[0]},
                   y = at.y + Real(-1) * Polynomial{o.y[0]};
  const Real ax = o.x[1], bx = o.x[2], ay = o.y[1], by = o.y[2];
  if (abs(ax * by - ay * bx) < Real(1e-30)) {  // a line
    const bool bends = bx * bx + by * by > ax * ax + ay * ay;
    return bends ? bx * y + (-by) * x : ax * y + (-ay) * x;
  }
  const Polynomial of_bend = bx * y + (-by) * x, of_start = ax * y + (-ay) * x;
  return of_bend * of_bend + (-(ax * by - ay * bx)) * of_start;
}

QuadBezier stretch(const QuadBezier& c, double s, double t) {
  const auto polar = [&](double u, double v) {
    return (1 - u) * ((1 - v) * c.p0 + v * c.p1) + u * ((1 - v) * c.p1 + v * c.p2);
  };
  return {polar(s, s), polar(s, t), polar(t, t)};
}

/// Where the side may begin or cease to be outline.
std::vector<double> cuts_of(const QuadBezier& side, const std::vector<QuadBezier>& sides) {
  constexpr double kOn = 1e-9;
  std::vector<double> cuts{0, 1};
  for (const QuadBezier& other : sides) {
    for (const Real t : roots_in(meeting(side, other), 0, 1)) cuts.push_back(double(t));
    const NearestPoint foot = nearest(side, other.p0);
    if (foot.distance < kOn) cuts.push_back(foot.t);
  }
  const CriticalPoints turns = critical_points(side, side.p0 + 1e3 * (side.p1 - side.p0));
  for (int i = 0; i < turns.count; ++i)
    cuts.push_back(turns.t[std::size_t(i)]);  // where it folds back
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

ExactOutline::ExactOutline(const Path& path) : path_(path) {
  constexpr double kShortest = 1e-11, kAside = 1e-10;
  const std::vector<QuadBezier> sides = sides_of(path);
  const auto inside = [&](glm::dvec2 p) {
    const int winding = winding_upwards(path, p);
    return path.rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
  };
  for (const QuadBezier& side : sides) {
    const std::vector<double> cuts = cuts_of(side, sides);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const QuadBezier part = stretch(side, cuts[i - 1], cuts[i]);
      const glm::dvec2 middle = point(part, 0.5), way = tangent(part, 0.5);
      const double length = std::hypot(way.x, way.y);
      if (!(std::hypot(part.p0.x - middle.x, part.p0.y - middle.y) > kShortest) || !(length > 0))
        continue;
      const glm::dvec2 left = kAside / length * glm::dvec2{-way.y, way.x};
      (inside(middle + left) != inside(middle - left) ? stretches_ : hidden_).push_back(part);
    }
  }
}

double ExactOutline::distance(glm::dvec2 p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const QuadBezier& part : stretches_) least = std::min(least, mien::distance(part, p));
  const int winding = winding_upwards(path_, p);
  const bool in = path_.rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
  return in ? -least : least;
}

}  // namespace mien::test
