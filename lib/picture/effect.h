#pragma once
// Effects as data: what can be applied to a finished picture.

#include <mien/api.h>
#include <mien/color.h>
#include <mien/expected.h>

#include <string_view>
#include <variant>

namespace mien {

/// Square tiles that start at the picture's top left corner. Each has the exact mean of the pixels it
/// covers, in linear light, or the colour of the pixel at its centre. A bevelled border is light above
/// and on the left, and dark below and on the right.
struct MosaicEffect {
  int tiles = 24;
  double border = 0;    ///< width of the bevel, 0 (none) … 1 (pyramids), in half tiles
  bool center = false;  ///< the centre's colour instead of the mean
};

/// Lines along the sides of square cells that start at the picture's top left corner. The picture's own
/// left, right and upper sides carry the inner half of a line.
struct GridEffect {
  int cells = 12;
  double width = 1;  ///< of a line [px]
  Color color{1, 1, 1, 0.5};
};

using Effect = std::variant<MosaicEffect, GridEffect>;

/// The largest number of tiles or cells across the picture.
inline constexpr int kMostTiles = 65536;

/// "mosaic:24", "mosaic:24,0.3", "mosaic:24,0.3,center", "grid:12", "grid:12,2.5",
/// "grid:12,2.5,#ffffff80". The error's `where` is the text.
MIEN_API Expected<Effect> read_effect(std::string_view text);

}  // namespace mien
