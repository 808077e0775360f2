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
  /// [px] Of what is left of 1: how far the foot is. 0: its kink does not show.
  float foot;
};

/// A ramp between two of its kinks as the base colour: premultiplied, in the blending space.
struct LampRamp {
  enum class Kind : unsigned char { none, linear, radial, distance } kind = Kind::none;
  float x = 0, y = 0;  ///< its centre; otherwise t at the tile's middle, at distance 0, is x
  float xx = 0, xy = 0, yx = 0,
        yy = 0;  ///< as a dome's; linear: t grows by xx along x, xy along y; distance: by xx
  std::array<float, 4> at{}, slope{};  ///< the colour is at + t slope
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
  float level_shine = 0, level_power = -126;  ///< and the power of 2 that it is
  float shininess = 1;
  /// [levels] What a slope of 1 changes light by, if it went on as it begins from none.
  float by_slope = 100;
  std::vector<LampDome> domes;  ///< that reach the tile
  float finest =
      1e9f;  ///< [px] half the width of the narrowest dome, or of the narrowest highlight on one
  /// Of the most that a highlight's bends in both directions and its peak can be at once.
  static constexpr float kUsualBend = 0.35f;
  /// [1/px²] What colours bend by over a round profile and along a ramp: second derivatives, white being 1.
  float bend = 0;
  LampRamp ramp;  ///< instead of `light`

  bool varies() const {
    return rise_kind != Rise::none || !domes.empty() || ramp.kind != LampRamp::Kind::none;
  }
  bool is_round() const { return rise_kind == Rise::round; }
  bool goes_by_distance() const { return ramp.kind == LampRamp::Kind::distance; }
};

/// The piece's light around `middle`, within `radius`; uses what `to` has allocated. A ramp needs its segment.
void set_lamp(const LitSurface& surface, const LitPiece& piece, glm::dvec2 middle, double radius,
              LampLanes& to);

}  // namespace mien
