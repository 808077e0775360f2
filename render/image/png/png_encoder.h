#pragma once
// PNG (ISO/IEC 15948), written directly: a few chunks around one zlib stream, which is made of
// strips that several threads compress.

#include "render/image/picture_encoder.h"

namespace mien {

/// PNG of 8 or 16 bits (f32 becomes 16), sRGB, straight alpha, RGB where the frame is opaque. The
/// bytes depend on the picture and the recipe alone.
MadeEncoder png_encoder(const EncoderRequest& request);

}  // namespace mien
