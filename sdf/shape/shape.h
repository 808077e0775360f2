#pragma once
// Every shape that mien can draw, as plain data, and the functions that query it.
//
//   distance(shape, p)        signed distance, negative inside, in the units of the shape's numbers
//   exactness(shape)          whether that distance is exact or a bound, outside and inside
//   bounds(shape)             a box that contains the inside (sides may be infinite)
//   transformed(map, shape)   the same shape in another space
//   shape_name(shape)         its name in printed scenes
//
// All are total: any finite numbers give a result, degenerate ones included. A NaN coordinate gives
// distance +infinity (outside). Every distance is 1-Lipschitz and zero exactly on the outline.

#include <mien/api.h>
#include <mien/box2.h>
#include <mien/ellipse.h>
#include <mien/map.h>
#include <mien/quad_bezier.h>

#include <glm/vec2.hpp>
#include <string_view>
#include <variant>
#include <vector>

namespace mien {

/// Points p with dot(p, normal) <= offset.
struct HalfPlane {
  glm::dvec2 normal;  ///< unit, outward
  double offset;
};

/// The inside of a parabola: with q = p − vertex, dot(q, axis) >= bend · cross(axis, q)².
/// bend 0 is a half-plane, bend < 0 the outside of the mirrored parabola.
struct ParabolaSide {
  glm::dvec2 vertex;
  glm::dvec2 axis;  ///< unit, points to the inside
  double bend;      ///< 1 / length
};

/// The area between two parabolas: the intersection of both insides. The distance is exact, by arcs and
/// corners. If the insides have nothing in common, it is that to the farther side: positive everywhere.
struct Band {
  ParabolaSide lower, upper;
};

/// All points within `radius` of `center`.
struct Disc {
  glm::dvec2 center;
  double radius;  ///< >= 0
};

/// A disc cut by two parallel chords: −lower·radius <= dot(p − center, up) <= upper·radius.
struct CutDisc {
  glm::dvec2 center;
  double radius;        ///< >= 0
  double upper, lower;  ///< >= 0; chord distances in radii, 1 or more: no cut
  glm::dvec2 up;        ///< unit
};

struct Triangle {
  glm::dvec2 a, b, c;  ///< in either orientation
};

/// All points within half_width of the segment ab: a line with round caps.
struct Line {
  glm::dvec2 a, b;
  double half_width;  ///< >= 0
};

/// All points within half_width of a polyline, with round caps and joins. Where segments overlap, the
/// distance inside is that to the nearest segment's own outline, which is a bound.
struct Polyline {
  std::vector<glm::dvec2> points;  ///< at least 1
  double half_width;               ///< >= 0
};

/// All points within half_width of a quadratic Bézier, with round caps.
struct QuadStroke {
  QuadBezier spine;
  double half_width;  ///< >= 0
};

/// A pen line of varying width: the union of the discs (spine(t), w(t)), t in [0, 1], where
/// w(t) = (1−t)² w.0 + 2t(1−t) w.1 + t² w.2 >= 0. The distance is the minimum over t of |p − spine(t)| − w(t).
struct TaperedStroke {
  QuadBezier spine;
  double half_width[3];  ///< >= 0 each
};

enum class FillRule { nonzero, even_odd };

/// The area enclosed by closed loops of quadratic Béziers. A straight side has p1 halfway. The distance is that to the
/// nearest side; where loops overlap it is a bound inside, and scenes measure to the visible outline instead
/// (Scene::outlined_shape).
struct Path {
  struct Loop {
    std::vector<QuadBezier>
        sides;  ///< each begins where the previous one ends; the last ends where the first begins
  };
  std::vector<Loop> loops;
  FillRule rule = FillRule::nonzero;
};

using Shape = std::variant<HalfPlane, ParabolaSide, Band, Disc, CutDisc, Ellipse, Triangle, Line,
                           Polyline, QuadStroke, TaperedStroke, Path>;

/// What a distance promises away from the outline. Its zeros and its sign are exact for every shape.
struct Exactness {
  bool outside = true;  ///< true: the distance to the outline; false: at most that (a bound)
  bool inside = true;
  friend bool operator==(const Exactness&, const Exactness&) = default;
};

MIEN_API double distance(const HalfPlane&, glm::dvec2 p);
MIEN_API double distance(const ParabolaSide&, glm::dvec2 p);
MIEN_API double distance(const Band&, glm::dvec2 p);
MIEN_API double distance(const Disc&, glm::dvec2 p);
MIEN_API double distance(const CutDisc&, glm::dvec2 p);
MIEN_API double distance(const Ellipse&, glm::dvec2 p);
MIEN_API double distance(const Triangle&, glm::dvec2 p);
MIEN_API double distance(const Line&, glm::dvec2 p);
MIEN_API double distance(const Polyline&, glm::dvec2 p);
MIEN_API double distance(const QuadStroke&, glm::dvec2 p);
MIEN_API double distance(const TaperedStroke&, glm::dvec2 p);
MIEN_API double distance(const Path&, glm::dvec2 p);
MIEN_API double distance(const Shape&, glm::dvec2 p);

MIEN_API Exactness exactness(const Shape&);
MIEN_API Box2 bounds(const Shape&);

/// The shape under a similarity. Distances are multiplied by the scale of `linear`; nothing else changes.
MIEN_API Shape transformed(const glm::dmat2& linear, glm::dvec2 shift, const Shape&);
/// The same, written to `to`, which keeps its memory if it holds the same kind of shape.
void transform(const glm::dmat2& linear, glm::dvec2 shift, const Shape&, Shape& to);
template <class To, class From>
Shape transformed(const Map<To, From>& map, const Shape& shape) {
  return transformed(map.linear, map.shift, shape);
}

/// "half_plane", "parabola_side", …: the name used in printed scenes.
MIEN_API std::string_view shape_name(const Shape&);

}  // namespace mien
