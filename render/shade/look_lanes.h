#pragma once
// Looks at many places at once: the one way in which layers are laid over each other, whether places are whole
// pixels, parts of pixels or cells of one.

#include <mien/mix_mode.h>
#include "render/shade/color_row.h"

#include <array>
#include <vector>

namespace mien {

/// Places of one row of pixels, each with an area around it. Lanes read up to kColorSpare beyond the last one.
struct LanePlaces {
  int count;
  const float* column;        ///< of their pixels: whole numbers
  const float *x, *y;         ///< centroids from their pixels' middles
  const float *xx, *xy, *yy;  ///< variances about them
};

/// A step of a look. A ramp's place t is linear, or for a radial one with q = U (p − center)
///
///     mean of t  =  sqrt(|q|² + tr(UᵀU V) − qᵀU V Uᵀq / |q|²),   V: the variances,
///
/// to second order; third and fourth order add up to 0.0075 slope / r² or less (measured; r: px from the centre).
struct LaneStep {
  enum class Kind : unsigned char {
    open,    ///< begin with `color`: the picture's ground, or a group's
    over,    ///< lay `color` over it, by `mode`
    linear,  ///< lay a ramp over it
    radial,
    given,  ///< lay colours over it that are given
    close   ///< the group ends: lay it over what was there, times color[3], by `mode`
  } kind;
  MixMode mode = MixMode::normal;
  std::array<float, 4> color{};  ///< of a ramp: where t = from
  std::array<float, 4> slope{};  ///< by t
  float from = 0, length = 0;    ///< of the ramp: t is held between from and from + length
  float origin = 0;              ///< a column, near which floats count from
  std::array<float, 2> q{}, by_x{},
      by_y{};                       ///< at its middle, and what they change by; linear: t − from
  float uxx = 0, uxy = 0, uyy = 0;  ///< UᵀU
  float neglects = 0, most = 0;     ///< times |q|⁻², and at most
  std::array<const float*, 4> given{};  ///< planes
};

/// Writes the looks' colours to planes, and to `neglected` the errors of radial means; whole vectors. Returns the
/// largest of the errors, those of spare places among them. `stack` is scratch.
float shade_lanes(const std::vector<LaneStep>& steps, const LanePlaces& at,
                  std::vector<float>& stack, ColorRow& to, std::vector<float>& neglected);

}  // namespace mien
