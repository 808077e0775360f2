#pragma once
// Random numbers without a state: a pure function of what is asked, so that any frame can be posed
// alone, in any order, again.

#include <bit>
#include <cstdint>

namespace mien {

/// A number in [0, 1), evenly spread, for a seed, a stream and a count; 53 random bits.
///
/// Source. The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", 2014), once for each argument.
constexpr double chance(std::uint32_t seed, std::uint32_t stream, double count) {
  const auto mixed = [](std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  const std::uint64_t who = std::uint64_t(seed) << 32 | stream;
  return double(mixed(mixed(who) ^ std::bit_cast<std::uint64_t>(count + 0.0)) >> 11) * 0x1p-53;
}

}  // namespace mien
