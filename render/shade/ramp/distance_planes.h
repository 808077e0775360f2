#pragma once
// How a distance varies over a pixel: what 4 × 4 pixels see at their middles and corners at once. Where a pixel's
// quadratic holds at its corners, it tells planes for as many cells as are asked for; elsewhere a pixel is looked at in
// cells, each with the mean that a ridge through it leaves.

#include "render/shade/nearest/near_area.h"
#include "render/shade/ramp/softness.h"

#include <memory>
#include <vector>

namespace mien {

/// Keeps its scratch; one per thread.
class DistancePlanes {
 public:
  DistancePlanes();
  ~DistancePlanes();
  DistancePlanes(DistancePlanes&&) noexcept;
  DistancePlanes& operator=(DistancePlanes&&) noexcept;

  /// Forgets all areas.
  void begin();

  /// Writes the planes of a pixel, row by row, in side × side cells or a multiple of that; returns the side. A cell's t
  /// is the distance's mean over it, as exact as the ramp wants it of all of the pixel or of any `part`. 0: there are too many branches.
  int of(const FeetArea& area, int x, int y, int side, bool part, const RampSoftness& ramp,
         std::vector<RampPlane>& to);

  /// The feet that were looked for since they were last taken.
  long long take_feet();

 private:
  struct Tile;
  Tile& tile(const FeetArea& area, int x, int y, int side);
  int cells(Tile& tile, int x, int y, int side, bool part, const RampSoftness& ramp,
            std::vector<RampPlane>& to);

  std::vector<std::unique_ptr<Tile>> tiles_;  ///< by place and area
  std::vector<BranchPair> seen_;              ///< by sixteen cells
};

}  // namespace mien
