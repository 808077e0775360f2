#pragma once
// Every shape mien can draw, as plain data, and the questions a shape answers.
//
//   distance(shape, p)        signed distance, negative inside, in the units of the shape's numbers
//   exactness(shape)          whether that distance is exact or a bound, outside and inside
//   bounds(shape)             a box that contains the inside (sides may be infinite)
//   transformed(map, shape)   the same shape in another space
//   shape_name(shape)         its name, as printed scenes have it
//
// All are total: any finite numbers, degenerate ones included, give an answer; a NaN coordinate
// gives distance +infinity (outside).  Every distance is 1-Lipschitz and zero exactly on the
// outline.

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

/// Between two parabolas: the intersection of both insides. Exact distance, by arcs and corners. If
/// they have nothing in common the distance is that to the farther side: positive everywhere.
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
  glm::dvec2 a, b, c;  ///< either way round
};

/// All points within half_width of the segment a b: a line with round ends.
struct Line {
  glm::dvec2 a, b;
  double half_width;  ///< >= 0
};

/// All points within half_width of a polyline: round caps and joins. Inside, where pieces overlap,
/// the distance is to the nearest piece's own outline: a bound.
struct Polyline {
  std::vector<glm::dvec2> points;  ///< at least 1
  double half_width;               ///< >= 0
};

/// All points within half_width of a quadratic Bézier: round ends.
struct QuadStroke {
  QuadBezier spine;
  double half_width;  ///< >= 0
};

/// The union of the discs (spine(t), w(t)), t in [0, 1], with w(t) = (1−t)² w.0 + 2t(1−t) w.1 + t²
/// w.2 >= 0: a pen line of varying width. distance = min over t of |p − spine(t)| − w(t).
struct TaperedStroke {
  QuadBezier spine;
  double half_width[3];  ///< >= 0 each
};

enum class FillRule { nonzero, even_odd };

/// The area enclosed by closed loops of quadratic Béziers. A straight side has p1 halfway.
struct Path {
  struct Loop {
    std::vector<QuadBezier>
        sides;  ///< each begins where the one before ends; the last ends at the first's begin
  };
  std::vector<Loop> loops;
  FillRule rule = FillRule::nonzero;
};

using Shape = std::variant<HalfPlane, ParabolaSide, Band, Disc, CutDisc, Ellipse, Triangle, Line,
                           Polyline, QuadStroke, TaperedStroke, Path>;

/// What a distance promises off the outline. On the outline and in its sign every shape is exact.
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

/// The same shape seen through a similarity: distances grow by `linear`'s scale, nothing else
/// changes.
MIEN_API Shape transformed(const glm::dmat2& linear, glm::dvec2 shift, const Shape&);
/// The same, written to `to`, whose memory is kept where it is of the same kind.
void transform(const glm::dmat2& linear, glm::dvec2 shift, const Shape&, Shape& to);
template <class To, class From>
Shape transformed(const Map<To, From>& map, const Shape& shape) {
  return transformed(map.linear, map.shift, shape);
}

/// "half_plane", "parabola_side", …: the name used in printed scenes.
MIEN_API std::string_view shape_name(const Shape&);

}  // namespace mien
