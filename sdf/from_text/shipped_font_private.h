#pragma once

#include <cstddef>

namespace mien {

/// The bytes of font/DejaVuSans.ttf, put into the program when it is built.
extern const unsigned char kShippedFont[];
extern const std::size_t kShippedFontSize;

}  // namespace mien
