#pragma once
// Which of many stretches along x meet one? Asked for every piece the sweep comes to.

#include <cstddef>
#include <cstdint>

namespace mien {

/// Stretches side by side: low[i] to high[i], ends included. Both are read up to kReachSpare beyond the
/// last.
struct Reaches {
  const float *low, *high;
  std::size_t count;
};
inline constexpr std::size_t kReachSpare = 8;

/// A bit for each, the first one lowest: whether it has a point in common with `low` to `high`. Writes
/// whole bytes; bits beyond the last mean nothing.
void meeting(const Reaches& of, float low, float high, std::uint8_t* to);

}  // namespace mien
