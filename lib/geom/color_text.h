#pragma once
// Colours as people write them.

#include <mien/lib/base/api.h>
#include <mien/lib/geom/color.h>

#include <optional>
#include <string_view>

namespace mien {

/// "#rrggbb" or "#rrggbbaa", sRGB-encoded, upper or lower case; nothing else.
MIEN_API std::optional<Color> color_from_text(std::string_view text);

}  // namespace mien
