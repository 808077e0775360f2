#pragma once
// A PNG in memory, for who sends it instead of keeping it.

#include <mien/image.h>
#include <mien/write.h>

#include <cstddef>
#include <vector>

namespace mien {

/// The bytes that write_image writes into a file; of `how` only dpi and the recipe count. The picture has pixels.
std::vector<std::byte> png_bytes(const Image& image, const WriteOptions& how = {});

}  // namespace mien
