#pragma once
// Random scenes as pictures, every pixel judged: by the reference first, which is fast, and where that
// is in doubt by the exact truth, which decides.

#include <mien/scene.h>
#include <mien/view.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mien::test {

/// lattice, jittered (the same shaken by 1e-13, 1e-6 and 1e-3 in turn), generic, huge, strokes, painted;
/// false where there is no such kind.
bool fuzzed_scene(std::string_view kind, std::uint64_t seed, Scene& scene);

struct FuzzTally {
  long scenes = 0, pictures = 0, pixels = 0;
  long doubted = 0;   ///< pictures in which some order was not proven
  long resolved = 0;  ///< pixels drawn by distances, therefore or for their paints
  long asked = 0;     ///< pixels that the truth was asked about
  long disputed = 0;  ///< of those: off by the truth alone
  long over = 0;      ///< off by more than 1 of 255 or 32 of 65535, by both
  double worst = 0;   ///< of those asked about, in shares of what is allowed
  std::string where;  ///< the last that is over
};

/// Draws a scene `side` pixels wide and high, at 8 and 16 bits in one blend, or in both.
void judge_fuzzed(const Scene& scene, int side, FuzzTally& tally, std::optional<Blend> only = {});

}  // namespace mien::test
