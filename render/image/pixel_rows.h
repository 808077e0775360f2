#pragma once
// Rows of an image in the depth a file wants.

#include <mien/render/image.h>

#include <cstddef>
#include <vector>

namespace mien {

/// Gives rows of an image in another depth: encoded to linear and back (IEC 61966-2-1), straight
/// alpha to premultiplied and back. Between u8 and u16 levels map exactly (257 to 1). Rounding is
/// to the nearest level.
class PixelRows {
 public:
  PixelRows(const Image& image, Depth wanted);

  /// Rows first … end − 1, RGBA, without padding; valid until the next call. Rows in the wanted
  /// depth are not copied.
  const std::byte* rows(int first, int end);

 private:
  const Image& image_;
  Depth wanted_;
  std::vector<float> linear_;  // of every level, where levels become light
  std::vector<std::byte> buffer_;
};

}  // namespace mien
