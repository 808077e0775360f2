#pragma once
// The value of a curve in time at a moment.

#include <mien/motion.h>

#include <cstdint>

namespace mien {

/// What a clip plays by, beside the time.
struct Temper {
  std::uint64_t seed = 0;  ///< the face's: personal seeds are mixed with it
  double liveliness =
      1;  ///< at least 0: keys with a share of the periods are played in so much of it
};

/// The curve's value at `time` [s], finite. At a key it is the key's value exactly.
double value_at(const Curve& curve, double time, const Temper& temper = {});

/// Whether liveliness sets how often a curve is played. How far all others go is for the caller to scale.
bool is_played_by_chance(const Curve& curve);

}  // namespace mien
