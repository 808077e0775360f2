#pragma once
// What an area is painted with: one colour, or colours that vary with the place; and, if it has a
// relief, how its surface rises, for the light to fall on.
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

/// A handle to an area of a scene under construction, valid in its builder and the scene it
/// becomes.
struct Area {
  int node = -1;
};

/// A colour at a place along a gradient. Two stops at one place are a sudden change.
struct Stop {
  double at;
  Color color;
};

/// What a gradient is beyond its first and last stop.
enum class Extend : unsigned char {
  pad,     ///< the colour of the nearer end
  repeat,  ///< from the other end again
  reflect  ///< back again
};

/// 0 at `from`, 1 at `to`, the same all along every line square to that. from == to: 1 everywhere.
struct LinearGradient {
  glm::dvec2 from, to;
};

/// 0 at the centre, 1 on the ellipse, and beyond it. A radius of 0: 1 everywhere.
struct RadialGradient {
  glm::dvec2 center, radii;
  glm::dvec2 axis{1.0, 0.0};  ///< unit; where radii.x points
};

/// 0 where the signed distance to the outline of an area (negative inside) is `from`, 1 where it is
/// `to`. The distance is the area's own (Scene::distance): exact where Scene::exactness says so.
struct DistanceGradient {
  Area area;
  double from, to;
};

/// Colours along a place in [0, 1] and beyond. Between two stops they are mixed in the space that
/// the picture is blended in, premultiplied by their opacity.
struct Gradient {
  std::variant<LinearGradient, RadialGradient, DistanceGradient> along;
  std::vector<Stop> stops;  ///< at least 1; places do not fall
  Extend extend = Extend::pad;
};

/// How high a surface is at a distance inside an outline.
enum class Profile : unsigned char {
  flat,   ///< 0
  bevel,  ///< rises straight to 1 at `width` and stays
  round,  ///< rises like a quarter circle: sqrt(1 − (1 − x)²) with x = distance / width, and stays
  custom  ///< by a table
};

/// A hill that is added to a relief: height · (1 − ρ²)², ρ the place's distance from the centre
/// measured in radii; nothing outside. Slope and height are 0 all along its foot, so what it is
/// added to keeps no edge. This is how a cornea bulges a lid.
struct Dome {
  glm::dvec2 center, radii;   ///< radii > 0
  glm::dvec2 axis{1.0, 0.0};  ///< unit; where radii.x points
  double height;              ///< [face units]
};

/// A surface over a layer: height · profile(distance inside the outline of `area` / width), plus
/// domes. Its slope turns the colours by the scene's light (see Light).
struct Relief {
  Area area;  ///< whose outline the profile counts from; none (−1): the profile is flat
  Profile profile = Profile::flat;
  double width = 1;   ///< > 0
  double height = 0;  ///< may be negative: a dent
  /// Profile::custom: heights at equal steps from distance 0 to `width`, straight lines between; at
  /// least 2.
  std::vector<double> table;
  std::vector<Dome> domes;
  double specular = 0;    ///< 0 … 1: how strong the highlight is
  double shininess = 30;  ///< > 0: how small it is
};

/// One lamp, very far away, and light from everywhere. With n the surface's unit normal, l the unit direction to
/// the lamp and h the unit vector halfway between l and the viewer, a colour c (linear light) becomes
///
///     c · (ambient + (1 − ambient) · max(0, n·l) / l.z)  +  specular · max(0, (s(n) − s(z)) / (1 − s(z))),
///     s(n) = max(0, n·h)^shininess,     z the direction to the viewer
///
/// held within 0 … 1. A level surface (n = z) keeps its colour exactly: a flat relief is no relief.
struct Light {
  glm::dvec3 direction{-0.45, 0.65,
                       0.85};  ///< to the lamp: x right, y UP in the picture, z > 0 to us
  double ambient = 0.35;       ///< 0 … 1
};

struct Paint {
  Color color = {};  ///< opacity in color.a; with a gradient that opacity alone counts
  std::shared_ptr<const Gradient> gradient = {};  ///< none: `color` everywhere
  std::shared_ptr<const Relief> relief = {};      ///< none: not lit
};

/// Gradients and reliefs are shared, never changed.
inline std::shared_ptr<const Gradient> shared(Gradient gradient) {
  return std::make_shared<const Gradient>(std::move(gradient));
}
inline std::shared_ptr<const Relief> shared(Relief relief) {
  return std::make_shared<const Relief>(std::move(relief));
}

}  // namespace mien
