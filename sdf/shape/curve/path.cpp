#include "sdf/shape/curve/path.h"
#include <mien/quad_bezier_distance.h>

#include "path_sides_private.h"
#include "sdf/shape/segment_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// A piece of a side on which y runs one way, from y0 at t0 to y1 at t1.
struct Climb {
  double t0, y0, t1, y1;
};

/// The x of `side` where a climb passes height y, which lies between y0 and y1. One root of a
/// quadratic, found from the end where the climb is flat (the turn, if it has one), so nothing
/// cancels.
double x_at(const QuadBezier& side, const Climb& climb, double y) {
  const double a = side.p1.y - side.p0.y, b = (side.p2.y - side.p1.y) - a;
  const double c = side.p0.y - y;  // b t² + 2a t + c = 0
  const double root = std::sqrt(std::max(0.0, a * a - b * c));
  const double q = -(a + std::copysign(root, a));
  double t = climb.t0;
  double best = std::numeric_limits<double>::infinity();
  for (const double candidate : {q / b, c / q}) {
    const double within = std::clamp(candidate, climb.t0, climb.t1);
    if (std::abs(candidate - within) < best) {
      best = std::abs(candidate - within);
      t = within;
    }
  }
  const double s = 1.0 - t;
  return s * (s * side.p0.x + t * side.p1.x) + t * (s * side.p1.x + t * side.p2.x);
}

/// ±1 if the climb passes p's height to the right of p. A climb owns its lower end and not its
/// upper one, so that joints and turns are passed exactly as often as the outline does.
int passes(const QuadBezier& side, const Climb& climb, glm::dvec2 p) {
  const bool up = climb.y0 <= p.y && p.y < climb.y1, down = climb.y1 <= p.y && p.y < climb.y0;
  if (!up && !down) return 0;
  const double left = std::min({side.p0.x, side.p1.x, side.p2.x});
  const double right = std::max({side.p0.x, side.p1.x, side.p2.x});
  if (right <= p.x) return 0;
  if (left <= p.x && x_at(side, climb, p.y) <= p.x) return 0;
  return up ? 1 : -1;
}

/// A lower bound of the distance from p to a side: to the box of its control points.
double at_least(const QuadBezier& side, glm::dvec2 p) {
  const double x = std::max({std::min({side.p0.x, side.p1.x, side.p2.x}) - p.x,
                             p.x - std::max({side.p0.x, side.p1.x, side.p2.x}), 0.0});
  const double y = std::max({std::min({side.p0.y, side.p1.y, side.p2.y}) - p.y,
                             p.y - std::max({side.p0.y, side.p1.y, side.p2.y}), 0.0});
  return std::max(x, y);
}

}  // namespace

int passes(const QuadBezier& side, glm::dvec2 p) {
  if (p.y < std::min({side.p0.y, side.p1.y, side.p2.y}) ||
      p.y > std::max({side.p0.y, side.p1.y, side.p2.y}))
    return 0;
  const double a = side.p1.y - side.p0.y, b = (side.p2.y - side.p1.y) - a;
  const double turn = -a / b;
  if (is_straight(side) || !(turn > 0.0 && turn < 1.0))
    return passes(side, Climb{0.0, side.p0.y, 1.0, side.p2.y}, p);
  const double s = 1.0 - turn;
  const double y =
      s * (s * side.p0.y + turn * side.p1.y) + turn * (s * side.p1.y + turn * side.p2.y);
  return passes(side, Climb{0.0, side.p0.y, turn, y}, p) +
         passes(side, Climb{turn, y, 1.0, side.p2.y}, p);
}

double distance_to_side(const QuadBezier& side, glm::dvec2 p) {
  return is_straight(side) ? distance_to_segment(side.p0, side.p2, p) : distance(side, p);
}

int winding(const Path::Loop& loop, glm::dvec2 p) {
  int count = 0;
  for_each_side(loop, [&](const QuadBezier& side) { count += passes(side, p); });
  return count;
}

int winding(const Path& path, glm::dvec2 p) {
  int count = 0;
  for (const Path::Loop& loop : path.loops) count += winding(loop, p);
  return count;
}

// The nearest side, signed by the winding number. Outside it is the exact distance: the way to the
// nearest side passes through no other. Inside under the nonzero rule a side may have inside on
// both hands; then the distance is a bound (path_outline.h).
double distance(const Path& path, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return nearest;
  for (const Path::Loop& loop : path.loops)
    for_each_side(loop, [&](const QuadBezier& side) {
      if (at_least(side, p) < nearest) nearest = std::min(nearest, distance_to_side(side, p));
    });
  return is_inside(path.rule, winding(path, p)) ? -nearest : nearest;
}

}  // namespace mien
