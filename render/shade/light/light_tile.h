#pragma once
// A square of the picture's pixels, 16 wide or less, at multiples of its side: one piece of a lit paint, and the means
// of its pixels as far as they were asked for.
//
// A square of 16, 8 or 4 pixels is looked at by Gauss's 4 × 4 places. Where nothing breaks it (a ridge, a clamp of
// the law, the steep outline of a round profile) and its terms of third degree are small, the means of its pixels and of
// parts of them are those of the bicubic through these places, exactly. Else it is quartered. Pixels that are left are
// looked at by 4 × 4 cells, cut by ridges; by 8 × 8 to 128 × 128 where those do not suffice (docs/derivations/light.md).

#include "render/cover/part_form.h"
#include "render/shade/light/lamp_lanes.h"
#include "render/shade/nearest/near_area.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace mien {

/// The branches around a tile, and what of its squares is the same for all segments of a ramp: their tiles share it.
struct LightGround {
  static constexpr int kSquares = 1 + 4 + 16 + 64 + 256;

  struct Whose {
    std::uint64_t paint;
    int zone, x, y, side;
    bool operator==(const Whose&) const = default;
  };
  Whose whose{};
  std::uint64_t made = 0;  ///< how often
  bool crowded = false;    ///< too many branches: nothing here is of use
  NearArea area, gradient;
  std::vector<NearNode> near, near_gradient;  ///< by square and node, and those of a pixel
  /// Broken: entered, and a ridge or a steep outline breaks means over it.
  enum class State : std::uint8_t { unknown, entered, broken };
  std::array<State, kSquares> state;

  /// The feet that were looked for since they were last taken.
  long long take_feet() { return std::exchange(area.feet, 0) + std::exchange(gradient.feet, 0); }
};

/// Where a pixel's cells are looked at: of all tiles of a thread.
struct CellScratch {
  static constexpr int kMost = 4 * PartCells::kMost;  ///< that are listed of a level
  PartCells of_form;
  std::array<std::uint16_t, kMost> listed, open;
  /// What the open cells saw, and those whose quarters are listed: one and the other in turns.
  using Colors = std::array<std::array<float, kMost>, 4>;
  std::array<Colors, 2> colors;
  bool turned = false;

  Colors& of_open() { return colors[turned]; }
  Colors& wholes() { return colors[!turned]; }
};

struct LightTile {
  static constexpr int kSide = 16, kPixels = kSide * kSide;
  static constexpr int kLevels = 5, kSquares = LightGround::kSquares;
  static constexpr int kChannels = 4;

  LightGround* ground = nullptr;
  std::uint64_t of_ground = 0;     ///< its `made` when this was
  int x = 0, y = 0, side = kSide;  ///< its first pixel, and how many it has each way
  const RampSegment* segment = nullptr;

  LampLanes lamp;
  bool rises = false;  ///< the profile does: `area` counts
  bool apart = false;  ///< the ramp goes by a distance that is not the relief's: `gradient` counts
  float shallow = 0, deep = 0;
  float tolerance = 0;  ///< of a mean, in what colours are counted in
  int channels = 3;     ///< how many of them vary
  bool fine = false;    ///< of a picture of 16 bits and more

  /// Pixels: divided, and its own pixels were looked at.
  enum class State : std::uint8_t { unknown, smooth, divided, pixels };
  std::array<State, kSquares> state;
  struct Bicubic {
    alignas(64) float c[kChannels][16];  ///< at Gauss's places
    float bend =
        -1;  ///< the largest coefficient of second degree in a row or a column; −1: not asked yet
  };
  std::vector<Bicubic> kept;                  ///< of smooth squares
  std::array<std::uint16_t, kSquares> where;  ///< among those
  std::array<std::uint8_t, kPixels> known;
  std::array<std::array<float, kPixels>, kChannels> mean;
  float off = 0;  ///< what the answers since it was last 0 may be off by, of what a pixel may be
  CellScratch* scratch = nullptr;

  static constexpr int first_of(int level) { return ((1 << 2 * level) - 1) / 3; }
  static constexpr int square(int level, int i, int j) {
    return first_of(level) + (j << level) + i;
  }
  float middle() const { return 0.5f * float(side); }
  /// [px] Smaller ones are not looked at. For 16 bits four places do not do for a pixel.
  int smallest() const { return fine ? 1 : 2; }
  int squares() const { return fine ? kSquares : first_of(kLevels - 1); }

  /// Forgets what was known: of another place or piece.
  void begin();
  /// Forgets what was known of its ground, whose areas are new.
  void begin_ground();
};

/// Makes the mean of pixel (i, j) of the tile known.
void find_mean(LightTile& tile, int i, int j);

/// A part of a pixel: its form, and its centroid from the pixel's middle and area.
struct LitPart {
  const PartForm* form;
  float x, y, area;
};

/// By its cells: within what they leave.
LitPart part_of(const PartForm& form, const PartCells& cells);

/// The mean over a part of it.
std::array<float, 4> mean_of_part(LightTile& tile, int i, int j, const LitPart& part);

/// The colours at the centroids of its cells; of those without area 0.
void colors_of_cells(LightTile& tile, int i, int j, const PartCells& cells,
                     const std::array<float*, 4>& to);

}  // namespace mien
