#pragma once
// Which branches matter in a square.

#include <cstdint>

namespace mien {

struct NearBranches {
  std::uint64_t near = 0;   ///< may be nearest somewhere in it
  std::uint64_t local = 0;  ///< of those, the least among their neighbours
  float key = 0;            ///< the least |p − B| − w at its middle
  /// One branch is local and will stay so all over the square: squares in it need not look.
  bool sure = false;
  float x = 0, y = 0, foot = 0;  ///< its foot, seen from there
  float foot_x = 0, foot_y = 0;  ///< and how that moves with the place
};

/// By branch: its foot seen from the middle of the square that was entered last, and how that moves with the place.
struct BranchFeet {
  static constexpr int kStride = 64 + 16;
  alignas(64) float t[kStride], x[kStride], y[kStride];
};

}  // namespace mien
