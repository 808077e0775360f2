#include <mien/quad_bezier_distance.h>
#include <mien/shape.h>
#include "sdf/shape/curve/band.h"
#include "sdf/shape/curve/path.h"

#include <cmath>
#include <string_view>

namespace mien {
namespace {

/// An empty band has no outline; its distance is the farther side's.
Exactness exactness_of(const Band& s) {
  return {!is_empty(s), true};
}
Exactness exactness_of(const Polyline& s) {
  return {true, s.points.size() <= 2};
}

/// Inside, walking away from the spine leaves it at speed 1 until the centre of curvature is
/// passed; a parabola's arc has no narrower place.
Exactness exactness_of(const QuadStroke& s) {
  return {true, s.half_width <= smallest_curvature_radius(s.spine)};
}
Exactness exactness_of(const TaperedStroke&) {
  return {true, false};
}
Exactness exactness_of(const Path& s) {
  return {true, is_simple(s)};
}
template <class Other>
Exactness exactness_of(const Other&) {
  return {true, true};
}

std::string_view name_of(const HalfPlane&) {
  return "half_plane";
}
std::string_view name_of(const ParabolaSide&) {
  return "parabola_side";
}
std::string_view name_of(const Band&) {
  return "band";
}
std::string_view name_of(const Disc&) {
  return "disc";
}
std::string_view name_of(const CutDisc&) {
  return "cut_disc";
}
std::string_view name_of(const Ellipse&) {
  return "ellipse";
}
std::string_view name_of(const Triangle&) {
  return "triangle";
}
std::string_view name_of(const Line&) {
  return "line";
}
std::string_view name_of(const Polyline&) {
  return "polyline";
}
std::string_view name_of(const QuadStroke&) {
  return "quad_stroke";
}
std::string_view name_of(const TaperedStroke&) {
  return "tapered_stroke";
}
std::string_view name_of(const Path&) {
  return "path";
}

/// Carries figures through a similarity.
struct Carrier {
  glm::dmat2 linear;
  glm::dvec2 shift;
  double scale = std::hypot(linear[0].x, linear[0].y);

  glm::dvec2 operator()(glm::dvec2 p) const { return linear * p + shift; }
  glm::dvec2 direction(glm::dvec2 unit) const { return (linear * unit) / scale; }

  QuadBezier operator()(const QuadBezier& c) const {
    return {(*this)(c.p0), (*this)(c.p1), (*this)(c.p2)};
  }
  HalfPlane operator()(const HalfPlane& s) const {
    const glm::dvec2 normal = direction(s.normal);
    return {normal, scale * s.offset + (normal.x * shift.x + normal.y * shift.y)};
  }
  ParabolaSide operator()(const ParabolaSide& s) const {
    return {(*this)(s.vertex), direction(s.axis), s.bend / scale};
  }
  Band operator()(const Band& s) const { return {(*this)(s.lower), (*this)(s.upper)}; }
  Disc operator()(const Disc& s) const { return {(*this)(s.center), scale * s.radius}; }
  CutDisc operator()(const CutDisc& s) const {
    return {(*this)(s.center), scale * s.radius, s.upper, s.lower, direction(s.up)};
  }
  Ellipse operator()(const Ellipse& s) const {
    return {(*this)(s.center), scale * s.radii, direction(s.axis)};
  }
  Triangle operator()(const Triangle& s) const {
    return {(*this)(s.a), (*this)(s.b), (*this)(s.c)};
  }
  Line operator()(const Line& s) const {
    return {(*this)(s.a), (*this)(s.b), scale * s.half_width};
  }
  Polyline operator()(const Polyline& s) const {
    Polyline out = s;
    move(out);
    return out;
  }
  void move(Polyline& s) const {
    s.half_width *= scale;
    for (glm::dvec2& p : s.points) p = (*this)(p);
  }
  QuadStroke operator()(const QuadStroke& s) const {
    return {(*this)(s.spine), scale * s.half_width};
  }
  TaperedStroke operator()(const TaperedStroke& s) const {
    return {(*this)(s.spine),
            {scale * s.half_width[0], scale * s.half_width[1], scale * s.half_width[2]}};
  }
  Path operator()(const Path& s) const {
    Path out = s;
    move(out);
    return out;
  }
  void move(Path& s) const {
    for (Path::Loop& loop : s.loops)
      for (QuadBezier& side : loop.sides) {
        const bool straight = side.p1 == 0.5 * (side.p0 + side.p2);
        side = (*this)(side);
        if (straight) side.p1 = 0.5 * (side.p0 + side.p2);  // straight sides stay so, to the bit
      }
  }
};

}  // namespace

double distance(const Shape& shape, glm::dvec2 p) {
  return std::visit([&](const auto& s) { return distance(s, p); }, shape);
}

Exactness exactness(const Shape& shape) {
  return std::visit([](const auto& s) { return exactness_of(s); }, shape);
}

Shape transformed(const glm::dmat2& linear, glm::dvec2 shift, const Shape& shape) {
  return std::visit([carry = Carrier{linear, shift}](const auto& s) { return Shape(carry(s)); },
                    shape);
}

void transform(const glm::dmat2& linear, glm::dvec2 shift, const Shape& shape, Shape& to) {
  const Carrier carry{linear, shift};
  const auto in_place = [&]<class Figure>(const Figure& s) {
    if (Figure* known = std::get_if<Figure>(&to))
      *known = s;
    else
      to = s;
    carry.move(std::get<Figure>(to));
  };
  if (const auto* path = std::get_if<Path>(&shape)) return in_place(*path);
  if (const auto* line = std::get_if<Polyline>(&shape)) return in_place(*line);
  to = transformed(linear, shift, shape);
}

std::string_view shape_name(const Shape& shape) {
  return std::visit([](const auto& s) { return name_of(s); }, shape);
}

}  // namespace mien
