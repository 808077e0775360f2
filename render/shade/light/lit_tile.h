#pragma once
// A tile of 16 × 16 pixels at multiples of 16: one zone of a lit paint at the pixels' middles, and the means of
// those pixels for which that suffices.

#include "render/shade/light/lit_pixel.h"

#include <array>
#include <cstdint>

namespace mien {

struct LitTile {
  static constexpr int kSide = 16, kRow = kSide + 2;
  static constexpr int kPlaces = kRow * kRow, kPadded = (kPlaces + 15) / 16 * 16 + 16;
  static constexpr int kPixels = kSide * kSide;

  enum class Kind : unsigned char {
    base,      ///< level all over: the base colour
    means,     ///< by the planes below
    distances  ///< of a gradient's area: mean_r
  } kind = Kind::means;

  // Whose it is.
  std::uint64_t paint = 0;
  int zone = 0, x = 0, y = 0;  ///< its first pixel

  bool rises = false;  ///< else there are no feet
  bool full = false;   ///< everything but the smooth means is made
  bool smooth = false;
  std::array<float, kPixels> smooth_r, smooth_g, smooth_b;  ///< means, where the tile is smooth
  float shallow, deep;
  /// [levels] Smaller tolerances are those of pictures of 16 bits and more.
  static constexpr float kFine = 0.1f;
  static constexpr float kSame = 0.02f;
  float same =
      kSame;  ///< gradients that agree this well, seen from one block and from the next, are of one branch
  bool tangled = false;  ///< feet at the blocks' middles do not reveal what lies between
  LampLanes lamp;
  NearFeet feet;

  /// Feet are found at the middles of blocks of 2 × 2 pixels; the first blocks lie half outside the tile.
  static constexpr int kBlocks = kRow / 2, kFeet = (kBlocks * kBlocks + 15) / 16 * 16 + 32;
  std::array<float, kFeet> block_d, block_nx, block_ny, block_bend;
  std::array<float, kPadded> d{}, nx{}, ny{}, bend{};  ///< at middles, one more all around
  std::array<float, kPixels> ridge;  ///< how far away the nearest ridge is, if it is near
  std::array<float, kPadded> r, g, b;
  std::array<float, kPixels> mean_r, mean_g, mean_b;
  enum class Trust : std::uint8_t {
    around,  ///< the mean follows from the middles around
    within,  ///< it follows from places within the pixel, and the foot at its middle serves for all of these
    calm,  ///< it does not, but the foot at its middle serves for the whole pixel
    none   ///< there may be a ridge, or level lines bend strongly
  };
  std::array<Trust, kPixels> trust;

  /// Of pixel (i, j) of the tile, from its middle.
  glm::vec2 middle(int i, int j) const {
    return {float(i) + 0.5f - 0.5f * kSide, float(j) + 0.5f - 0.5f * kSide};
  }
};

/// The places at which a tile is evaluated to find whether it is smooth, from its middle: Gauss's and its border
/// every 2 px.
struct SmoothPlaces {
  static constexpr int kCount = 48;
  std::array<float, kCount> x, y, d{}, nx{}, ny{}, bend{};
  SmoothPlaces();
};

/// Sets the smooth means where a polynomial through Gauss's 4 × 4 places is within `tolerance` (of 1, as encoded)
/// of all of the border's colours. A ridge or a kink crosses the border, or changes the inner places' colours too
/// much for the polynomial.
bool smooth_means(const SmoothPlaces& at, float tolerance, LitTile& tile);

/// Predicts what all places see from the blocks' feet.
void spread_feet(LitTile& tile);

/// Light at all places, then means and where they are rough. `levels`: the permitted error of a mean.
void shade_tile(LitTile& tile, float levels);

/// Mean distances, and where they are rough.
void judge_distances(LitTile& tile);

}  // namespace mien
