#pragma once
// One row of a picture in a display's format.

#include <mien/device_pixels.h>

namespace mien {

/// The depth of the pixels that a format's are made of.
Depth depth_for(DeviceFormat format);

/// Packs `width` pixels of depth_for(format), which begin at column x of row y of the picture.
void pack_row(DeviceFormat format, const std::byte* from, int x, int y, int width, bool dither,
              std::byte* to);

}  // namespace mien
