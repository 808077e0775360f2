#include "parabola_private.h"

#include "cross_private.h"

#include <mien/lib/math/quartic.h>
#include <mien/sdf/shape/parabola_side.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace mien {
namespace {

/// [1/px] A parabola bent more is a ray, whatever the picture.
constexpr double kMostBend = 1e12;

/// Coordinates of p in a side's frame: u along its outline, v towards its inside.
glm::dvec2 in_frame(const ParabolaSide& side, glm::dvec2 p) {
  const glm::dvec2 q = p - side.vertex;
  return {cross(side.axis, q), glm::dot(q, side.axis)};
}

/// The control point of the side's outline from u to w.
glm::dvec2 control(const ParabolaSide& side, double u, double w) {
  return side.vertex + 0.5 * (u + w) * turned(side.axis) + (side.bend * u * w) * side.axis;
}

struct Side {
  glm::dvec2 control, to;
};

/// The inside of a parabola, cut off beyond a box around the window: from `begin` along four sides.
struct Closed {
  glm::dvec2 begin;
  std::array<Side, 4> sides;
};

Closed closed(const ParabolaSide& side, const Box2& window) {
  Box2 seen;
  for (const double x : {window.lo.x, window.hi.x})
    for (const double y : {window.lo.y, window.hi.y}) seen = around(seen, in_frame(side, {x, y}));
  const double margin = 1.0 + 0.01 * (seen.size().x + seen.size().y);
  const double u = seen.lo.x - margin, w = seen.hi.x + margin;
  const double top = margin + std::max({seen.hi.y, side.bend * u * u, side.bend * w * w});
  const auto at = [&](double x, double y) {
    return side.vertex + x * turned(side.axis) + y * side.axis;
  };
  // From high u to low: with u to the left of the axis the inside is on the turned side.
  Closed c;
  c.begin = point(side, w);
  const glm::dvec2 corners[] = {point(side, u), at(u, top), at(w, top), c.begin};
  c.sides[0] = {control(side, u, w), corners[0]};
  for (int i = 1; i < 4; ++i) c.sides[i] = {0.5 * (corners[i - 1] + corners[i]), corners[i]};
  return c;
}

ParabolaSide tamed(ParabolaSide side) {
  side.bend = std::clamp(side.bend, -kMostBend, kMostBend);
  return side;
}

/// Writes what of a closed outline lies inside a parabola's side, as one pen.
class CutWriter {
 public:
  CutWriter(CurvePen& pen, const ParabolaSide& side) : pen_(pen), side_(side) {}

  void quad(glm::dvec2 p, glm::dvec2 control, glm::dvec2 to) {
    const glm::dvec2 a = control - p, b = (to - control) - a;
    std::array<double, 6> cut{0.0};
    int count = 1;
    const QuarticRoots roots = crossings(p, a, b);
    for (int i = 0; i < roots.count; ++i)
      if (roots.x[i] > 0.0 && roots.x[i] < 1.0) cut[count++] = roots.x[i];
    cut[count] = 1.0;
    for (int i = 0; i < count; ++i) {
      const double s = cut[i], t = cut[i + 1], middle = 0.5 * (s + t);
      if (!inside(p + middle * (2.0 * a + middle * b))) continue;
      enter(p + s * (2.0 * a + s * b));
      last_ = t < 1.0 ? p + t * (2.0 * a + t * b) : to;
      pen_.quad(p + ((s + t) * a + (s * t) * b), last_);
    }
  }

  void close() {
    if (!begun_) return;
    enter(first_);
    pen_.close();
  }

 private:
  bool inside(glm::dvec2 p) const {
    const glm::dvec2 q = in_frame(side_, p);
    return q.y >= side_.bend * q.x * q.x;
  }

  /// Parameters of p + t (2a + t b) where it crosses the side's outline.
  QuarticRoots crossings(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) const {
    const glm::dvec2 c0 = in_frame(side_, p);
    const glm::dvec2 c1 = 2.0 * glm::dvec2(cross(side_.axis, a), glm::dot(a, side_.axis));
    const glm::dvec2 c2{cross(side_.axis, b), glm::dot(b, side_.axis)};
    const double k = side_.bend;
    return solve_quartic(-k * c2.x * c2.x, -2.0 * k * c1.x * c2.x,
                         c2.y - k * (c1.x * c1.x + 2.0 * c0.x * c2.x), c1.y - 2.0 * k * c0.x * c1.x,
                         c0.y - k * c0.x * c0.x);
  }

  /// To `p`, where the outline comes in: along the side from where it went out.
  void enter(glm::dvec2 p) {
    if (!begun_) {
      pen_.begin(p);
      begun_ = true;
      first_ = last_ = p;
    }
    if (p == last_) return;
    pen_.quad(control(side_, in_frame(side_, last_).x, in_frame(side_, p).x), p);
    last_ = p;
  }

  CurvePen& pen_;
  const ParabolaSide& side_;
  bool begun_ = false;
  glm::dvec2 first_{0}, last_{0};
};

}  // namespace

void write_half_plane(CurvePen& pen, const HalfPlane& side) {
  write_parabola_side(pen, {side.offset * side.normal, -side.normal, 0.0});
}

void write_parabola_side(CurvePen& pen, const ParabolaSide& side) {
  const Closed c = closed(tamed(side), pen.window());
  pen.begin(c.begin);
  for (const Side& s : c.sides) pen.quad(s.control, s.to);
  pen.close();
}

void write_band(CurvePen& pen, const Band& band) {
  const ParabolaSide upper = tamed(band.upper);
  const Closed c = closed(tamed(band.lower), pen.window());
  CutWriter cut(pen, upper);
  glm::dvec2 p = c.begin;
  for (const Side& s : c.sides) {
    cut.quad(p, s.control, s.to);
    p = s.to;
  }
  cut.close();
}

}  // namespace mien
