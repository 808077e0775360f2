#pragma once
// How a gradient's place varies over a pixel: by planes, one in each of as many cells as the kind of gradient needs.

#include "render/shade/paint_table.h"
#include "render/shade/ramp/radial_planes.h"
#include "render/shade/ramp/sums.h"

namespace mien {

/// Keeps its scratch; one per thread.
class RampPlanes {
 public:
  /// Adds those of pixel (x, y), scaled, row by row, in side × side cells or a multiple of that. Returns the side. A
  /// paint along a distance needs its LitPaint.
  int add(const VariedPaint& varied, const LitPaint* lit, int x, int y, int side,
          LitPaint::Scratch& scratch, std::vector<RampPlane>& to);

  /// The means over whole pixels of a row, of a radial paint.
  void radial_row(const VariedPaint& varied, int x, int y, int count, ColorRow& to);

 private:
  struct Distances {
    const LitPaint& lit;
    LitPaint::Scratch& scratch;
    int x, y;

    void at(const PartCells& places, float* d) const {
      lit.distances_of_cells(x, y, places, d, scratch);
    }
  };
  int smooth_distance(const VariedPaint& varied, const Distances& distances, int side,
                      double allowed, std::vector<RampPlane>& to);
  int distance_cells(const VariedPaint& varied, const Distances& distances, int side,
                     double allowed, std::vector<RampPlane>& to);

  PartCells tried_;  ///< places, up to a pixel's border
  RampBoxes boxes_;
  RadialPlaces places_;
  std::vector<RampPlane> cells_;
  std::vector<float> bends_, excesses_;
  std::vector<int> bent_;  ///< pixels
  ColorRow finer_;
};

}  // namespace mien
