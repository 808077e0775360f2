#pragma once
// Colours as people write them.

#include <mien/color.h>

#include <optional>
#include <string_view>

namespace mien {

/// "#rrggbb" or "#rrggbbaa", sRGB-encoded, upper or lower case; nothing else.
std::optional<Color> color_from_text(std::string_view text);

}  // namespace mien
