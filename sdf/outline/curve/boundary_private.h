#pragma once
#include <mien/map.h>
#include <mien/shape.h>
#include "sdf/outline/curve/curve_pen.h"

namespace mien {

/// Draws what bounds a shape, in pixels: shapes that are not the discs of a pen.
struct BoundaryWriter {
  CurvePen& pen;
  const Map<GridSpace, FaceSpace>& map;
  double scale;

  void operator()(const HalfPlane& s) const;
  void operator()(const ParabolaSide& s) const;
  void operator()(const Band& s) const;
  void operator()(const Disc& s) const;
  void operator()(const CutDisc& s) const;
  void operator()(const Ellipse& s) const;
  void operator()(const Triangle& s) const;
  void operator()(const Path& s) const;

  glm::dvec2 unit(glm::dvec2 v) const { return map.direction(v) / scale; }
  ParabolaSide side(const ParabolaSide& s) const {
    return {map(s.vertex), unit(s.axis), s.bend / scale};
  }
  void write_loop(const Path::Loop& loop) const;
};

}  // namespace mien
