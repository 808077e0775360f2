#include "tools/mien/output/captioned_sheet.h"
#include "lib/base/one_line.h"
#include "sdf/from_face/caption.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace mien::command {
namespace {

constexpr int kMostColumns = 1000, kMostGap = 1000;       // gaps in pixels
constexpr std::size_t kMostBytes = std::size_t(1) << 30;  // of the whole sheet

/// Copies a picture to a place of the sheet.
void lay(Image& sheet, const Image& picture, int x, int y) {
  for (int r = 0; r < picture.height; ++r)
    std::memcpy(sheet.bytes.data() + sheet.stride() * std::size_t(y + r) + std::size_t(x) * 4,
                picture.bytes.data() + picture.stride() * std::size_t(r), picture.stride());
}

}  // namespace

Expected<SheetLayout> read_sheet_layout(const std::optional<std::string>& columns,
                                        int default_columns,
                                        const std::optional<std::string>& gap) {
  const auto wide =
      read_whole("--columns", columns.value_or(std::to_string(default_columns)), 1, kMostColumns);
  if (!wide) return wide.error();
  const auto apart = read_whole("--gap", gap.value_or("0"), 0, kMostGap);
  if (!apart) return apart.error();
  return SheetLayout{int(*wide), int(*apart)};
}

Expected<Image> captioned_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout) {
  for (const SheetCell& cell : cells)
    if (!is_utf8(cell.caption))
      return Error{"sheet", fmt::format("the name {} is not UTF-8, or holds a NUL",
                                        in_quotes(cell.caption))};
  const int width = cells[0].image.width, height = cells[0].image.height;
  const bool named =
      std::ranges::any_of(cells, [](const SheetCell& c) { return !c.caption.empty(); });
  const int strip = named ? std::max(12, height / 9) : 0, count = int(cells.size());
  const int columns = std::min(layout.columns, count), gap = layout.gap;
  const std::size_t rows = std::size_t((count + columns - 1) / columns);
  const std::size_t wide = std::size_t(columns) * std::size_t(width + gap) - std::size_t(gap),
                    high = rows * std::size_t(height + strip + gap) - std::size_t(gap);
  if (wide * high > kMostBytes / 4) return Error{"sheet", "larger than a GiB"};
  Image sheet{.width = int(wide), .height = int(high)};
  sheet.bytes.assign(sheet.stride() * high, std::byte{255});
  for (int i = 0; i < count; ++i) {
    const SheetCell& cell = cells[std::size_t(i)];
    const int x = i % columns * (width + gap), y = i / columns * (height + strip + gap);
    lay(sheet, cell.image, x, y);
    if (!cell.caption.empty())
      lay(sheet,
          sheet_picture(caption_scene(letters(), cell.caption, double(width) / strip),
                        {.width = width, .height = strip}),
          x, y + height);
  }
  return sheet;
}

}  // namespace mien::command
