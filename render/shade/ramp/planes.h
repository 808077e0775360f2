#pragma once
// How a gradient's place varies over a pixel: by planes, one in each of as many cells as the kind of gradient needs.

#include "render/shade/paint_table.h"
#include "render/shade/ramp/mean.h"

namespace mien {

/// Keeps its scratch; one per thread.
class RampPlanes {
 public:
  /// Of pixel (x, y), scaled, in side × side cells or a multiple of that; a paint along a distance needs its LitPaint.
  const RampCells& of(const VariedPaint& varied, const LitPaint* lit, int x, int y, int side,
                      LitPaint::Scratch& scratch);

 private:
  struct Distances {
    const LitPaint& lit;
    LitPaint::Scratch& scratch;
    int x, y;

    void at(const PartCells& places, float* d) const {
      lit.distances_of_cells(x, y, places, d, scratch);
    }
  };
  bool smooth_distance(const VariedPaint& varied, const Distances& distances, int side,
                       double allowed);
  const RampCells& distance_cells(const VariedPaint& varied, const Distances& distances, int side,
                                  double allowed);

  PartCells tried_;  ///< places, up to a pixel's border
  RampCells cells_;
};

}  // namespace mien
