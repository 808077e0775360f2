#include "boundary_private.h"

#include "arc_private.h"
#include "cross_private.h"
#include "parabola_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// What is left of a shape without area: a line there and back.
void write_segment(CurvePen& pen, glm::dvec2 a, glm::dvec2 b) {
  pen.begin(a);
  pen.line(b);
  pen.close();
}

}  // namespace

void BoundaryWriter::operator()(const HalfPlane& s) const {
  const glm::dvec2 normal = unit(s.normal), on = map(s.offset * s.normal);
  write_half_plane(pen, {normal, glm::dot(on, normal)});
}

void BoundaryWriter::operator()(const ParabolaSide& s) const {
  write_parabola_side(pen, side(s));
}

void BoundaryWriter::operator()(const Band& s) const {
  write_band(pen, {side(s.lower), side(s.upper)});
}

void BoundaryWriter::operator()(const Disc& s) const {
  if (s.radius > 0.0) write_disc(pen, map(s.center), scale * s.radius);
}

/// Two arcs and two chords.
void BoundaryWriter::operator()(const CutDisc& s) const {
  const glm::dvec2 center = map(s.center), up = unit(s.up), left = turned(up);
  const double r = scale * s.radius;
  if (!(r > 0.0)) return write_segment(pen, center, center);
  if (pen.beyond({center - r, center + r})) return;
  const double top = std::min(s.upper, 1.0), low = std::min(s.lower, 1.0);
  const double wide_top = std::sqrt((1.0 - top) * (1.0 + top));
  const double wide_low = std::sqrt((1.0 - low) * (1.0 + low));
  const double turn = std::asin(top) + std::asin(low);
  const glm::dvec2 corners[] = {top * up + wide_top * left, wide_low * left - low * up,
                                -wide_low * left - low * up, top * up - wide_top * left};
  pen.begin(center + r * corners[0]);
  write_arc(pen, center, r, corners[0], turn, center + r * corners[1]);
  pen.line(center + r * corners[2]);
  write_arc(pen, center, r, corners[2], turn, center + r * corners[3]);
  pen.close();
}

void BoundaryWriter::operator()(const Ellipse& s) const {
  const glm::dvec2 u = s.radii.x * s.axis, v = s.radii.y * turned(s.axis);
  if (!(s.radii.x > 0.0 && s.radii.y > 0.0))
    return write_segment(pen, map(s.center - (u + v)), map(s.center + (u + v)));
  write_ellipse(pen, map(s.center), map.direction(u), map.direction(v));
}

void BoundaryWriter::operator()(const Triangle& s) const {
  pen.begin(map(s.a));
  pen.line(map(s.b));
  pen.line(map(s.c));
  pen.close();
}

void BoundaryWriter::operator()(const Path& s) const {
  for (const Path::Loop& loop : s.loops)
    if (!loop.sides.empty()) write_loop(loop);
}

/// Gaps between sides are closed by straight sides, as in the distance.
void BoundaryWriter::write_loop(const Path::Loop& loop) const {
  Box2 box;
  for (const QuadBezier& side : loop.sides)
    box = around(around(around(box, map(side.p0)), map(side.p1)), map(side.p2));
  if (pen.beyond(box)) return;
  glm::dvec2 end = loop.sides.front().p0;
  pen.begin(map(end));
  for (const QuadBezier& side : loop.sides) {
    if (side.p0 != end) pen.line(map(side.p0));
    pen.quad(map(side.p1), map(side.p2));
    end = side.p2;
  }
  pen.close();
}

}  // namespace mien
