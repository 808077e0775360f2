#pragma once
// What an area is painted with: one colour, or a gradient. A relief adds the shape of its surface, on
// which the scene's light falls.
//
//   Paint{{1, 0, 0, 1}}                                                     // red
//   Paint{.color = {0, 0, 0, 0.5},                                          // half-transparent …
//         .gradient = shared(Gradient{LinearGradient{a, b}, {{0, red}, {1, blue}}})}
//
// All lengths and places are in face units.

#include <mien/color.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace mien {

/// A handle to an area of a scene. It is valid in the builder that made it and in the finished scene.
struct Area {
  int node = -1;
};

/// A colour at a place along a gradient. Two stops at one place make a sharp edge.
struct Stop {
  double at;
  Color color;
};

/// How a gradient continues beyond its first and last stop.
enum class Extend : unsigned char {
  pad,     ///< the colour of the nearer end
  repeat,  ///< starts again from the other end
  reflect  ///< runs back and forth
};

/// 0 at `from`, 1 at `to`, and constant along lines perpendicular to that. If from == to: the last stop's colour
/// everywhere, however it is extended (as in SVG).
struct LinearGradient {
  glm::dvec2 from, to;
};

/// 0 at the centre, 1 on the ellipse, and more outside it. If a radius is 0: the last stop's colour everywhere, too.
struct RadialGradient {
  glm::dvec2 center, radii;
  glm::dvec2 axis{1.0, 0.0};  ///< unit; where radii.x points
};

/// 0 where the signed distance to an area's outline (negative inside) is `from`, 1 where it is `to`. The
/// distance is Scene::distance, which is exact where Scene::exactness is. If from == to: the first stop's colour before,
/// the last one's beyond, however it is extended.
struct DistanceGradient {
  Area area;
  double from, to;
};

/// Colours over [0, 1] and beyond. Between two stops they are interpolated in the picture's blend space,
/// premultiplied by their opacity.
struct Gradient {
  std::variant<LinearGradient, RadialGradient, DistanceGradient> along;
  std::vector<Stop> stops;  ///< at least 1; places never decrease
  Extend extend = Extend::pad;
};

/// The height of a surface as a function of the distance inside an outline.
enum class Profile : unsigned char {
  flat,   ///< 0
  bevel,  ///< rises straight to 1 at `width` and stays
  round,  ///< rises like a quarter circle: sqrt(1 − (1 − x)²) with x = distance / width, and stays
  custom  ///< by a table
};

/// A hill added to a relief: height · (1 − ρ²)², where ρ is the distance from the centre in radii; 0 for
/// ρ > 1. Height and slope are 0 along its foot, so it leaves no edge. This is how a cornea bulges a
/// lid.
struct Dome {
  glm::dvec2 center, radii;   ///< radii > 0
  glm::dvec2 axis{1.0, 0.0};  ///< unit; where radii.x points
  double height;              ///< [face units]
};

/// A surface over a layer: height · profile(distance inside the outline of `area` / width), plus domes.
/// The scene's light shades the layer's colours by the slope of that surface (see Light).
struct Relief {
  Area area;  ///< the profile starts at its outline; none (−1): the profile is flat
  Profile profile = Profile::flat;
  double width = 1;   ///< > 0
  double height = 0;  ///< may be negative: a dent
  /// For Profile::custom: at least 2 heights, at equal steps from distance 0 to `width`, interpolated
  /// linearly.
  std::vector<double> table;
  std::vector<Dome> domes;
  double specular = 0;    ///< 0 … 1: how strong the highlight is
  double shininess = 30;  ///< > 0: how small it is
};

/// One lamp at infinity and ambient light. Let n be the surface's unit normal, l the unit direction to the lamp and
/// h the unit vector halfway between l and the direction to the viewer. A colour c (linear light) becomes
///
///     c · (ambient + (1 − ambient) · max(0, n·l) / l.z)  +  specular · max(0, (s(n) − s(z)) / (1 − s(z))),
///     s(n) = max(0, n·h)^shininess,     z the direction to the viewer
///
/// clamped to 0 … 1. A level surface (n = z) keeps its colour exactly, so a flat relief changes nothing.
struct Light {
  glm::dvec3 direction{-0.45, 0.65,
                       0.85};  ///< to the lamp: x right, y UP in the picture, z > 0 to us
  double ambient = 0.35;       ///< 0 … 1
};

struct Paint {
  Color color = {};  ///< with a gradient only its opacity, color.a, counts
  std::shared_ptr<const Gradient> gradient = {};  ///< none: `color` everywhere
  std::shared_ptr<const Relief> relief = {};      ///< none: not lit
};

/// Gradients and reliefs are shared and immutable.
inline std::shared_ptr<const Gradient> shared(Gradient gradient) {
  return std::make_shared<const Gradient>(std::move(gradient));
}
inline std::shared_ptr<const Relief> shared(Relief relief) {
  return std::make_shared<const Relief>(std::move(relief));
}

}  // namespace mien
