#pragma once
// Random numbers without a state: a pure function of the arguments, so that frames can be posed alone, in
// any order, and again.

#include "lib/base/mixed_bits.h"

#include <cstdint>
#include "lib/base/bit_cast.h"

namespace mien {

/// A uniformly distributed number in [0, 1) for a stream of numbers and a count; 53 random bits.
constexpr double chance(std::uint64_t stream, double count) {
  return double(mixed_bits(mixed_bits(stream) ^ mien::bit_cast<std::uint64_t>(count + 0.0)) >> 11) *
         0x1p-53;
}

/// The same for a stream of a small seed.
constexpr double chance(std::uint32_t seed, std::uint32_t stream, double count) {
  return chance(std::uint64_t(seed) << 32 | stream, count);
}

}  // namespace mien
