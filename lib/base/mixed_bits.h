#pragma once
// A hash of 64 bits to 64 bits.

#include <cstdint>

namespace mien {

/// Different for different arguments. Changing one bit of the argument changes about half of the result's.
///
/// Source. The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace mien
