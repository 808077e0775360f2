#include <mien/sdf/outline/outline_maker.h>

#include "arc_private.h"
#include "cross_private.h"
#include "parabola_private.h"
#include "polyline_private.h"
#include "stroke_private.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// Writes shapes whose numbers are in pixels already.
struct FillWriter {
  OutlineLoop& loop;
  std::vector<glm::dvec2>& points;
  const Map<GridSpace, FaceSpace>& map;
  double scale;

  QuadBezier curve(const QuadBezier& c) const { return {map(c.p0), map(c.p1), map(c.p2)}; }
  glm::dvec2 unit(glm::dvec2 v) const { return map.direction(v) / scale; }
  ParabolaSide side(const ParabolaSide& s) const {
    return {map(s.vertex), unit(s.axis), s.bend / scale};
  }

  void operator()(const HalfPlane& s) {
    const glm::dvec2 normal = unit(s.normal), on = map(s.offset * s.normal);
    write_half_plane(loop, {normal, glm::dot(on, normal)});
  }
  void operator()(const ParabolaSide& s) { write_parabola_side(loop, side(s)); }
  void operator()(const Band& s) { write_band(loop, {side(s.lower), side(s.upper)}); }
  void operator()(const Disc& s) {
    if (s.radius > 0.0) write_disc(loop, map(s.center), scale * s.radius);
  }
  void operator()(const CutDisc& s);
  void operator()(const Ellipse& s) {
    if (!(s.radii.x > 0.0 && s.radii.y > 0.0)) return;
    write_ellipse(loop, map(s.center), map.direction(s.radii.x * s.axis),
                  map.direction(s.radii.y * turned(s.axis)));
  }
  void operator()(const Triangle& s) {
    loop.begin(map(s.a));
    loop.line(map(s.b));
    loop.line(map(s.c));
    loop.close();
  }
  void operator()(const Line& s) {
    points.assign({map(s.a), map(s.b)});
    write_polyline(loop, points, scale * s.half_width);
  }
  void operator()(const Polyline& s) {
    points.clear();
    for (const glm::dvec2 p : s.points) points.push_back(map(p));
    write_polyline(loop, points, scale * s.half_width);
  }
  void operator()(const QuadStroke& s) {
    const double w = scale * s.half_width;
    write_stroke(loop, Pen(curve(s.spine), w, w, w));
  }
  void operator()(const TaperedStroke& s) {
    const double* w = s.half_width;
    write_stroke(loop, Pen(curve(s.spine), scale * w[0], scale * w[1], scale * w[2]));
  }
  void operator()(const Path& s) {
    for (const Path::Loop& l : s.loops) write_loop(l);
  }
  void write_loop(const Path::Loop& l);
};

/// Two arcs and two chords.
void FillWriter::operator()(const CutDisc& s) {
  const glm::dvec2 center = map(s.center), up = unit(s.up);
  const double r = scale * s.radius;
  if (!(r > 0.0) || loop.beyond({center - r, center + r})) return;
  const double top = std::min(s.upper, 1.0), low = std::min(s.lower, 1.0);
  const double wide_top = std::sqrt((1.0 - top) * (1.0 + top));
  const double wide_low = std::sqrt((1.0 - low) * (1.0 + low));
  const double turn = std::asin(top) + std::asin(low);
  const glm::dvec2 left = turned(up);
  const glm::dvec2 corners[] = {top * up + wide_top * left, wide_low * left - low * up,
                                -wide_low * left - low * up, top * up - wide_top * left};
  loop.begin(center + r * corners[0]);
  write_arc(loop, center, r, corners[0], turn, center + r * corners[1]);
  loop.line(center + r * corners[2]);
  write_arc(loop, center, r, corners[2], turn, center + r * corners[3]);
  loop.close();
}

/// Gaps between sides are closed as the distance does it: by straight sides.
void FillWriter::write_loop(const Path::Loop& l) {
  if (l.sides.empty()) return;
  Box2 box;
  for (const QuadBezier& side : l.sides)
    box = around(around(around(box, map(side.p0)), map(side.p1)), map(side.p2));
  if (loop.beyond(box)) return;
  glm::dvec2 end = l.sides.front().p0;
  loop.begin(map(end));
  for (const QuadBezier& side : l.sides) {
    if (side.p0 != end) loop.line(map(side.p0));
    loop.quad(map(side.p1), map(side.p2));
    end = side.p2;
  }
  loop.close();
}

FillRule rule_of(const Shape& shape) {
  const Path* path = std::get_if<Path>(&shape);
  return path ? path->rule : FillRule::nonzero;
}

}  // namespace

void OutlineMaker::begin(const OutlineFrame& frame, Outlines& to) {
  to.clear();
  map_ = frame.grid_from_face;
  scale_ = map_.scale();
  loop_.frame(frame.window, frame.tolerance, to);
}

int OutlineMaker::fill(const Shape& shape) {
  const int index = loop_.outline(rule_of(shape));
  std::visit(FillWriter{loop_, points_, map_, scale_}, shape);
  return index;
}

int OutlineMaker::rim(const Shape&, double) {
  return loop_.outline(FillRule::nonzero);
}

void OutlineMaker::finish() {
  loop_.finish();
}

}  // namespace mien
