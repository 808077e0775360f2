#pragma once
// One picture as a WebP, without loss: a film that does not move.

#include <mien/expected.h>
#include <mien/image.h>

#include <string>

namespace mien::command {

/// Of 8 bits. Errors leave `where` empty: libwebp's, or it is not installed.
Expected<std::string> webp_still(const Image& image);

}  // namespace mien::command
