#pragma once
// A tile of 16 × 16 pixels at multiples of 16: what a zone of a lit paint is like at the pixels'
// middles, and the means of those that these tell well enough.

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
  bool full = false;   ///< all but the smooth means is made
  bool smooth = false;
  std::array<float, kPixels> smooth_r, smooth_g, smooth_b;  ///< means, where the tile is smooth
  float shallow, deep;
  /// [levels] Less may be off where pictures have 16 bits and more.
  static constexpr float kFine = 0.1f;
  static constexpr float kSame = 0.02f;
  float same =
      kSame;  ///< gradients that agree so well seen from one block and from the next are of one branch
  bool tangled = false;  ///< feet in the blocks' middles do not tell of what lies between
  LampLanes lamp;
  NearFeet feet;

  /// Feet are looked for in the middles of blocks of 2 × 2 pixels, the first of which are half beyond the tile.
  static constexpr int kBlocks = kRow / 2, kFeet = (kBlocks * kBlocks + 15) / 16 * 16 + 32;
  std::array<float, kFeet> block_d, block_nx, block_ny, block_bend;
  std::array<float, kPadded> d{}, nx{}, ny{}, bend{};  ///< at middles, one more all around
  std::array<float, kPixels> ridge;  ///< how far beside the pixel the nearest is, if it is near
  std::array<float, kPadded> r, g, b;
  std::array<float, kPixels> mean_r, mean_g, mean_b;
  enum class Trust : std::uint8_t {
    around,  ///< the mean is right by the middles around
    within,  ///< it is right by places within the pixel, all of which its middle's foot tells
    calm,    ///< it is not, but the foot at its middle tells all of the pixel's
    none     ///< there may be a ridge, or level lines are bent much
  };
  std::array<Trust, kPixels> trust;

  /// Of pixel (i, j) of the tile, from its middle.
  glm::vec2 middle(int i, int j) const {
    return {float(i) + 0.5f - 0.5f * kSide, float(j) + 0.5f - 0.5f * kSide};
  }
};

/// Where a tile is looked at to find whether it is smooth, from its middle: Gauss's places and its border every 2 px.
struct SmoothPlaces {
  static constexpr int kCount = 48;
  std::array<float, kCount> x, y, d{}, nx{}, ny{}, bend{};
  SmoothPlaces();
};

/// The smooth means, where a polynomial through Gauss's 4 × 4 places is within `tolerance` (of 1, as encoded) of all of
/// the border's colours. A ridge or a kink crosses the border, or turns the inner places' colours too much for it.
bool smooth_means(const SmoothPlaces& at, float tolerance, LitTile& tile);

/// What the blocks' feet say at all places.
void spread_feet(LitTile& tile);

/// Light at all places, then means and where they are rough. `levels`: what a mean may be off.
void shade_tile(LitTile& tile, float levels);

/// Mean distances, and where they are rough.
void judge_distances(LitTile& tile);

}  // namespace mien
