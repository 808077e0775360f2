#pragma once
// How exactly distances along a ramp must be known, and where: between two kinks means of distances are all it takes.

#include "render/shade/paint.h"

#include <vector>

namespace mien {

/// Keeps its memory.
class RampSoftness {
 public:
  /// `left`: what a pixel may be off by as a share of the ramp's range. `ramp`: whose slope turns; none: a stretch
  /// between two kinks.
  void make(const PaintField& field, const RampIntegral& integral, double left, const Ramp* ramp);

  /// [px] What distances may be off by: that shifts the ramp.
  double allowed() const { return allowed_; }

  /// By how much the ramp's slope changes in all within `reach` px of a distance, as a share of the steepest slope;
  /// endless for ramps that jump.
  double turns(double distance, double reach) const;

 private:
  PaintField field_;
  double allowed_ = 0, period_ = 0;
  std::vector<double> at_,
      sums_;  ///< the kinks' places, and what slopes have changed by up to each
};

}  // namespace mien
