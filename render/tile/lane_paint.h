#pragma once
// Paints as the vectors see them: float numbers relative to a leaf's centre, and their colours at many
// places at once. lane_paint_simd.cpp is the twin of LocalPaint::color and Lamp::lit.

#include <mien/render/tile/leaf.h>
#include <mien/render/tile/paint.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mien {

/// What a distance is like in the cells of a leaf: around a cell's middle,
/// mean + x u.x + y u.y + xy u.x u.y, u in pixels.
struct LaneDistances {
  std::vector<float> mean, x, y, xy;  ///< by cell
};

struct LaneDome {
  float x, y;  ///< centre
  float u00, u01, u10,
      u11;  ///< takes the ellipse to the unit circle: u0 = u00 x + u10 y, as in glm
  float height;
};

/// A paint of one leaf.
struct LanePaint {
  static constexpr int kMostStops = 16;
  static constexpr int kMostSteps = 64;
  static constexpr float kFarthest = 64;  ///< a place t beyond has too few digits left

  // The colour, or the ramp and the place along it.
  std::array<float, 4> color;
  int stops = 0;  ///< 0: `color` everywhere
  std::array<float, kMostStops> at;
  std::array<std::array<float, 4>, kMostStops> mix;
  Extend extend = Extend::pad;
  PaintField::Kind kind = PaintField::Kind::linear;
  float place_x = 0, place_y = 0, shift = 0;  ///< linear; distance: shift + place_x · distance
  float cx = 0, cy = 0, u00 = 0, u01 = 0, u10 = 0, u11 = 0;  ///< radial
  const LaneDistances* place_distance = nullptr;

  // The relief.
  bool lit = false;
  std::array<float, 3> light;  ///< without a ramp: the colour in linear light, by itself
  const LaneDistances* distance = nullptr;
  Profile profile = Profile::flat;
  float width = 1, per_pixel = 0;  ///< height / width
  int steps = 0;                   ///< of a custom profile
  std::array<float, kMostSteps> rises;
  std::array<LaneDome, 8> domes;
  int dome_count = 0;
  std::array<float, 3> to_lamp, halfway;
  float ambient = 0, specular = 0, shininess = 1, level_shine = 0;
};

/// Whether a paint can be seen in vectors at all.
bool fits_lanes(const TapePaint& paint);

/// The paint around `center`; nothing if its numbers are too large there. The distances are the
/// caller's to set.
std::optional<LanePaint> lane_paint(const TapePaint& paint, Blend blend, glm::dvec2 center);

/// Layers one over the other, top to bottom: a colour, or a paint.
struct LaneLayer {
  int paint = -1;  ///< in the list given; −1: `color`
  std::array<float, 4> color{};
};

/// Places in a leaf, and the cells whose distances hold there.
struct LanePlaces {
  std::span<const float> x, y;  ///< [px] from the leaf's centre
  std::span<const std::int32_t> cell;
  const float *cell_x, *cell_y;  ///< their middles, by cell
};

/// What is seen at each place, as Mix has it, to four planes.
void lane_colors(std::span<const LaneLayer> layers, std::span<const LanePaint> paints, Blend blend,
                 const LanePlaces& places, std::array<float*, 4> out);

/// Mixes, in four planes, to pixels of 8 bits a channel; `carry` by pixel: what is added before
/// fractions of a level are dropped. As store() and store_dithered() do.
void lane_pixels(std::array<const float*, 4> mix, Blend blend, const float* carry,
                 std::size_t count, std::uint32_t* pixels);

}  // namespace mien
