#include <mien/effect.h>
#include "lib/base/memory_ran_out.h"

#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/picture/color_text.h"

#include <fmt/format.h>

#include <optional>
#include <vector>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

template <class Number>
std::optional<Number> number(std::string_view text, Number least, Number most) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [at, failed] = from_chars(text.data(), end, value);
  if (failed != std::errc{} || at != end || !(value >= least && value <= most)) return {};
  return value;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

Error refuse(std::string_view text, std::string what) {
  return {one_line(text, 60), std::move(what)};
}

Expected<Effect> mosaic(std::string_view text, const std::vector<std::string_view>& parts) {
  MosaicEffect mosaic;
  const auto tiles = number<int>(parts[0], 1, kMostTiles);
  if (!tiles) return refuse(text, fmt::format("expected 1 to {} tiles across", kMostTiles));
  mosaic.tiles = *tiles;
  if (parts.size() > 1) {
    const auto border = number<double>(parts[1], 0, 1);
    if (!border) return refuse(text, "a border goes from 0 (none) to 1 (pyramids)");
    mosaic.border = *border;
  }
  if (parts.size() > 2) {
    if (parts[2] != "mean" && parts[2] != "center")
      return refuse(text, "a tile shows its \"mean\" or its \"center\"");
    mosaic.center = parts[2] == "center";
  }
  if (parts.size() > 3) return refuse(text, "expected mosaic:TILES,BORDER,mean|center");
  return Effect{mosaic};
}

Expected<Effect> grid(std::string_view text, const std::vector<std::string_view>& parts) {
  GridEffect grid;
  const auto cells = number<int>(parts[0], 1, kMostTiles);
  if (!cells) return refuse(text, fmt::format("expected 1 to {} cells across", kMostTiles));
  grid.cells = *cells;
  if (parts.size() > 1) {
    const auto width = number<double>(parts[1], 0, 1e6);
    if (!width) return refuse(text, "a line's width is a number of pixels, 0 or more");
    grid.width = *width;
  }
  if (parts.size() > 2) {
    const auto color = color_from_text(parts[2]);
    if (!color) return refuse(text, "expected a colour like #rrggbb or #rrggbbaa");
    grid.color = *color;
  }
  if (parts.size() > 3) return refuse(text, "expected grid:CELLS,WIDTH,COLOUR");
  return Effect{grid};
}

}  // namespace

Expected<Effect> read_effect(std::string_view text) try {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  if (name != "mosaic" && name != "grid")
    return refuse(text, unknown_name("effect", name, {"mosaic", "grid"}));
  const auto parts =
      split(colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1));
  return name == "mosaic" ? mosaic(text, parts) : grid(text, parts);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
