#pragma once
// TIFF: libtiff keeps the file, tiles are compressed here, on several threads.

#include "render/image/picture_encoder.h"

namespace mien {

/// 8, 16 or 32-bit float as the frame is, in zip tiles of 256 (larger in pictures of over a million tiles); BigTIFF
/// where the pixels alone could reach 4 GiB. Levels have straight alpha, light is premultiplied; an ICC profile
/// gives the colour space.
MadeEncoder tiff_encoder(const EncoderRequest& request);

}  // namespace mien
