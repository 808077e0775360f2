#pragma once
// A lit paint in the form that lanes use: float numbers, places relative to a tile's middle.
// lamp_lanes-inl.h is the twin of LitSurface::color.

#include "render/shade/light/lit_surface.h"

#include <array>
#include <span>
#include <vector>

namespace mien {

struct LampDome {
  float x, y;            ///< its centre
  float xx, xy, yx, yy;  ///< u = xx x + xy y, v = yx x + yy y: 1 all along its foot
  float height;          ///< −4 × its height
};

/// A ramp as the base colour, along a line or from a centre. Colours are premultiplied, in the blending space.
struct LampRamp {
  enum class Kind : unsigned char { none, linear, radial } kind = Kind::none;
  float x = 0, y = 0;                    ///< its centre; linear: t at the tile's middle is x
  float xx = 0, xy = 0, yx = 0, yy = 0;  ///< as a dome's; linear: t grows by xx along x, xy along y
  struct Stretch {                       ///< between two stops
    float at, over;                      ///< where it begins; 1 / its length
    std::array<float, 4> change;
  };
  std::array<float, 4> first{};  ///< the colour before all of them
  std::vector<Stretch> stretches;
};

struct LampLanes {
  enum class Rise : unsigned char { none, constant, round } rise_kind = Rise::none;
  float rise = 0;  ///< height / width, or that of a straight step
  float width = 1, one_over_width = 1;
  bool linear = false;
  std::array<float, 3> light{};  ///< the base colour in linear light, by itself
  float alpha = 1;
  std::array<float, 3> to_lamp{}, halfway{};  ///< y DOWN
  float ambient = 0, diffuse = 1;             ///< (1 − ambient) / to_lamp.z
  float shine = 0;                            ///< specular / (1 − level_shine); 0: none
  float level_shine = 0, shininess = 1;
  std::vector<LampDome> domes;  ///< that reach the tile
  float finest =
      1e9f;  ///< [px] half the width of the narrowest dome, or of the narrowest highlight on one
  LampRamp ramp;  ///< instead of `light`

  /// Whether a round profile is so narrow that all of it lies within a pixel.
  bool is_narrow() const { return rise_kind == Rise::round && width < kNarrow; }
  static constexpr float kNarrow = 1.0f;  // [px]
};

/// Whether lanes can evaluate a paint's base: one colour, or a ramp of few stops along a line or from a centre that
/// ends in plain colours.
bool lanes_know(const GridPaint& paint);

/// The zone's light around `middle`, within `radius`; uses what `to` has allocated.
void set_lamp(const LitSurface& surface, int zone, glm::dvec2 middle, double radius, LampLanes& to);

}  // namespace mien
