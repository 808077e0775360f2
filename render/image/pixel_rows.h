#pragma once
// Pixels in the depth a file wants.

#include <mien/image.h>

#include <cstddef>
#include <vector>

namespace mien {

/// Turns pixels of one depth into another: encoded to linear and back (IEC 61966-2-1), straight
/// alpha to premultiplied and back. Between u8 and u16 levels map exactly (257 to 1). Rounding is
/// to the nearest level.
class PixelRows {
 public:
  PixelRows(Depth from, Depth to);

  /// `pixels` of them, RGBA. On several threads at once.
  void convert(const void* from, void* to, std::size_t pixels) const;

 private:
  Depth from_, to_;
  std::vector<float> linear_;  // of every level, where levels become light
};

}  // namespace mien
