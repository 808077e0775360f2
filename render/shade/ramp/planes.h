#pragma once
// How a gradient's place varies over a pixel: by planes, one in each of as many cells as the kind of gradient needs.

#include "render/shade/paint_table.h"
#include "render/shade/ramp/distance_planes.h"
#include "render/shade/ramp/radial_planes.h"
#include "render/shade/ramp/sums.h"

namespace mien {

/// Keeps its scratch; one per thread.
class RampPlanes {
 public:
  /// Forgets what it knows of a picture.
  void begin() { distances_.begin(), softness_of_ = nullptr; }

  /// The feet of distances that were looked for since they were last taken.
  long long take_feet() { return distances_.take_feet(); }

  /// Adds those of pixel (x, y), scaled, row by row, in side × side cells or a multiple of that. Returns the side. A
  /// paint along a distance needs its LitPaint. `ramp`: the paint's, or of a stretch of it between two kinks.
  int add(const VariedPaint& varied, const RampIntegral& ramp, const LitPaint* lit, int x, int y,
          int side, LitPaint::Scratch& scratch, std::vector<RampPlane>& to, bool part = false);

  /// The means over whole pixels of a row, of a radial paint.
  void radial_row(const VariedPaint& varied, int x, int y, int count, ColorRow& to);

 private:
  float excess_of(const VariedPaint& varied, const RampIntegral& ramp);
  const RampSoftness& softness(const VariedPaint& varied, const RampIntegral& ramp);

  DistancePlanes distances_;
  const RampIntegral* softness_of_ = nullptr;
  RampSoftness softness_;
  RampBoxes boxes_;
  RadialPlaces places_;
  std::vector<RampPlane> cells_;
  std::vector<float> bends_, excesses_;
  std::vector<int> bent_;  ///< pixels
  ColorRow finer_;
};

}  // namespace mien
