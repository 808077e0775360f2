#pragma once
// Layers that follow an outline at a distance: contours, glows and soft shadows.
//
//   soft_shadow(build, "shadow", head, {.color = {0, 0, 0, 0.5}, .blur = 0.1, .shift = {0.03, -0.04}});
//   build.layer("head", head, {skin});
//   build.layer("line", contour(build, head, 0.01), {ink});
//
// All of them use Scene::distance. It is the true distance to the outline where Scene::exactness is exact,
// as for every single shape. For combined areas it is a bound: a contour then has mitred instead of round
// corners, and a glow follows these mitres.

#include <mien/api.h>
#include <mien/scene.h>

#include <string>

namespace mien {

/// All points within half_width of the outline, on both sides of it.
MIEN_API Area contour(SceneBuilder& build, Area area, double half_width);

/// A contour that is drawn as by a pen held at an angle: half as wide as `thin` on the side away from
/// `toward`, as `thick` on that side. `toward` is unit, 0 <= thin <= thick.
///
/// What the area, grown by `thin`, has beyond its own shrunken copy, moved: with the outward normal n the line
/// is thin + thick + (thick − thin) dot(n, toward) wide. It grows inwards and never leaves a gap.
MIEN_API Area pen_contour(SceneBuilder& build, Area area, double thin, double thick,
                          glm::dvec2 toward);

/// The profile of a soft edge: 1 − 3u² + 2u³, from 1 at u = 0 to 0 at u = 1, level at both ends. It is
/// sampled at 17 places and interpolated linearly (error at most 0.003).
MIEN_API double soft_edge(double u);

struct Glow {
  Color color;   ///< with the opacity at the outline
  double reach;  ///< > 0: where the light ends
};

/// A light around an area: full inside and at the outline, falling by soft_edge to 0 at `reach`. Add it
/// before the layer that glows.
MIEN_API void glow(SceneBuilder& build, std::string name, Area area, const Glow& glow);

struct SoftShadow {
  Color color;          ///< with the opacity deep inside
  double blur;          ///< > 0: it falls by soft_edge from this deep inside to this far outside
  glm::dvec2 shift{0};  ///< offset of the shadow from the area
  Area on = {};         ///< it falls on this area only; none: on all that is below
};

/// A colour whose opacity falls by soft_edge from full at the distance `from` to 0 at `to`.
MIEN_API Paint falling(Area area, Color color, double from, double to);

/// A shadow of an area. Its opacity is a function of the distance. Along straight outlines this equals a
/// blur; at corners it is close to one.
MIEN_API void soft_shadow(SceneBuilder& build, std::string name, Area area,
                          const SoftShadow& shadow);

}  // namespace mien
