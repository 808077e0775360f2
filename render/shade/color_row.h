#pragma once
// Colours side by side, premultiplied, in the blending space.

#include <cstddef>
#include <vector>

namespace mien {

/// Lanes may read up to kColorSpare beyond the last colour.
struct ColorPlanes {
  const float *r, *g, *b, *a;
};
inline constexpr std::size_t kColorSpare = 16;

struct ColorRow {
  std::vector<float> r, g, b, a;

  /// For so many colours, and what lanes read beyond them.
  void room_for(std::size_t count) {
    count += kColorSpare;
    if (r.size() < count) r.resize(count), g.resize(count), b.resize(count), a.resize(count);
  }
  ColorPlanes planes() const { return {r.data(), g.data(), b.data(), a.data()}; }
};

}  // namespace mien
