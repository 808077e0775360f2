#pragma once
// Layers that follow an outline at a distance: strokes along it, light around it, shadows under it.
//
//   soft_shadow(build, "shadow", head, {.color = {0, 0, 0, 0.5}, .blur = 0.1, .shift = {0.03, -0.04}});
//   build.layer("head", head, {skin});
//   build.layer("line", contour(build, head, 0.01), {ink});
//
// All of them read the area's own distance (Scene::distance): the true distance to the outline where
// Scene::exactness says so, as for every shape alone; of combined areas it is a bound, so that a contour
// has mitred instead of round corners there and a glow follows the corners' mitres.

#include <mien/api.h>
#include <mien/scene.h>

#include <string>

namespace mien {

/// The ribbon within half_width of the outline, half of it inside.
MIEN_API Area contour(SceneBuilder& build, Area area, double half_width);

/// How a soft edge falls: 1 at u = 0, 0 at u = 1, 1 − 3u² + 2u³ between, level at both ends; taken
/// at 17 places with straight lines between (off by at most 0.003).
MIEN_API double soft_edge(double u);

struct Glow {
  Color color;   ///< with the opacity at the outline
  double reach;  ///< > 0: no light is farther away
};

/// Light around an area: full inside and at its outline, falling by soft_edge to nothing at `reach`.
/// To be added before the layer that glows.
MIEN_API void glow(SceneBuilder& build, std::string name, Area area, const Glow& glow);

struct SoftShadow {
  Color color;          ///< with the opacity deep inside
  double blur;          ///< > 0: falls by soft_edge from so deep inside to as far outside
  glm::dvec2 shift{0};  ///< where the shadow lies, seen from the area
};

/// A shadow of an area. Its opacity is a profile of the distance, which is what a blur gives along
/// straight outlines and something near it at corners.
MIEN_API void soft_shadow(SceneBuilder& build, std::string name, Area area,
                          const SoftShadow& shadow);

}  // namespace mien
