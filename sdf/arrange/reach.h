#pragma once
// Which of many intervals along x overlap a given one? Asked for every piece that the sweep meets.

#include <cstddef>
#include <cstdint>

namespace mien {

/// Intervals side by side: low[i] to high[i], ends included. Both arrays are read up to kReachSpare beyond the
/// last.
struct Reaches {
  const float *low, *high;
  std::size_t count;
};
inline constexpr std::size_t kReachSpare = 8;

/// A bit for each interval, the first one lowest: whether it shares a point with `low` to `high`. Writes whole
/// bytes; bits beyond the last mean nothing.
void meeting(const Reaches& of, float low, float high, std::uint8_t* to);

}  // namespace mien
