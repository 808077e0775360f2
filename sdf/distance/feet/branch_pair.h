#pragma once
// What sixteen places see of a distance: the nearest branch, and the one beyond the nearest ridge.
//
// A ridge is where two branches are equally near and the gradient jumps from one to the other. Branches change along
// their gradients, so a ridge lies (d' − d) / |n' − n| away in the direction of n − n' (of a least distance), up to
// how far level lines bend on the way. Distances change by at most one per length: no ridge lies nearer than half of
// their gap.

#include <mien/op.h>

namespace mien {

/// Signed distances and their gradients, by place.
struct BranchPair {
  static constexpr int kPlaces = 16;
  /// Stands for no ridge.
  static constexpr float kFar = 1e9f;
  struct Values {
    alignas(64) float d[kPlaces], nx[kPlaces], ny[kPlaces];
  };
  Values best, beyond;
  /// How far the ridge is, and the way to it, of length 1.
  alignas(64) float off[kPlaces], ex[kPlaces], ey[kPlaces];
};

/// What becomes of pairs when areas combine; `a` may be `to`. For one operand `b` is not read.
void combine_pairs(Op op, const BranchPair& a, const BranchPair& b, float amount, BranchPair& to);

}  // namespace mien
