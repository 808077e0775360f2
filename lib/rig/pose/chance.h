#pragma once
// Random numbers without a state: a pure function of the arguments, so that frames can be posed alone, in
// any order, and again.

#include "lib/base/mixed_bits.h"

#include <cstdint>
#include "lib/base/bit_cast.h"

namespace mien {

/// A uniformly distributed number in [0, 1) for a seed, a stream and a count; 53 random bits.
constexpr double chance(std::uint32_t seed, std::uint32_t stream, double count) {
  const std::uint64_t who = std::uint64_t(seed) << 32 | stream;
  return double(mixed_bits(mixed_bits(who) ^ mien::bit_cast<std::uint64_t>(count + 0.0)) >> 11) *
         0x1p-53;
}

}  // namespace mien
