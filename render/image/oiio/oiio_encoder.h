#pragma once
// EXR and JPEG, by OpenImageIO's writers.

#include "render/image/picture_encoder.h"

namespace mien {

/// EXR: half or 32-bit float, linear and premultiplied, zip; in lines, and wider than 8192 pixels in
/// tiles of 256, which bounds what is held at once. JPEG: 8 bits, sRGB, no subsampling.
MadeEncoder oiio_encoder(const EncoderRequest& request);

}  // namespace mien
