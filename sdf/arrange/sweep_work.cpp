// What a sweep tells its watch: how much it has done, and how much it holds.

#include "lib/base/watch.h"
#include "sdf/arrange/sweep.h"

#include <utility>

namespace mien {

std::size_t Sweep::bytes() const {
  return pieces_.capacity() * sizeof(SweepPiece) + fragments_.capacity() * sizeof(Fragment) +
         doubts_.capacity() * sizeof(Doubt) + events_.capacity() * sizeof(Event) +
         again_.capacity() * sizeof(again_[0]) +
         outlines_->pieces.capacity() * sizeof(OutlinePiece) +
         vertices_.capacity() * sizeof(Vertex) + regions_->bytes();
}

/// What was done since it was told last, by what each costs.
void Sweep::tell_work() {
  constexpr int kSteps = 200, kPair = 8, kCrossing = 80, kForced = 30, kProof = 30;
  constexpr int kOften = 16;  // times between two counts of what is held
  const auto done = [&](long SweepStats::*what, int steps) {
    return std::int64_t(stats_.*what - std::exchange(told_.*what, stats_.*what)) * steps;
  };
  const int regions = regions_->count();
  // Slots are looked through, and moved, for every vertex.
  worked(kSteps + 2 * count_ + done(&SweepStats::pairs, kPair) +
         done(&SweepStats::crossings, kCrossing) + done(&SweepStats::forced, kForced) +
         done(&SweepStats::proofs, kProof) +
         std::int64_t(regions - std::exchange(told_regions_, regions)) * regions_->steps());
  if (++since_held_ % kOften == 0) holds(bytes());
}

}  // namespace mien
