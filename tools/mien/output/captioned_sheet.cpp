#include "tools/mien/output/captioned_sheet.h"
#include "lib/base/one_line.h"
#include "sdf/from_face/caption.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

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

Expected<CaptionedSheet> CaptionedSheet::begin(int count, const SheetCell& first,
                                               const SheetLayout& layout) {
  CaptionedSheet made;
  made.width_ = first.image.width, made.height_ = first.image.height;
  made.strip_ = first.caption.empty() ? 0 : std::max(12, made.height_ / 9);
  made.columns_ = std::min(layout.columns, count), made.gap_ = layout.gap;
  const std::size_t rows = std::size_t((count + made.columns_ - 1) / made.columns_);
  const std::size_t wide = std::size_t(made.columns_) * std::size_t(made.width_ + made.gap_) -
                           std::size_t(made.gap_),
                    high = rows * std::size_t(made.height_ + made.strip_ + made.gap_) -
                           std::size_t(made.gap_);
  if (wide * high > kMostBytes / 4) return Error{"sheet", "larger than a GiB"};
  made.sheet_ = {.width = int(wide), .height = int(high)};
  made.sheet_.bytes.assign(made.sheet_.stride() * high, std::byte{255});
  made.captions_.resize(std::size_t(count));
  return made;
}

glm::ivec2 CaptionedSheet::corner(int place) const {
  return {place % columns_ * (width_ + gap_), place / columns_ * (height_ + strip_ + gap_)};
}

void CaptionedSheet::put(int place, SheetCell cell) {
  const glm::ivec2 at = corner(place);
  lay(sheet_, cell.image, at.x, at.y);
  captions_[std::size_t(place)] = std::move(cell.caption);
}

Expected<Image> CaptionedSheet::finish() && {
  for (int place = 0; place < int(captions_.size()); ++place) {
    const std::string& caption = captions_[std::size_t(place)];
    if (!is_utf8(caption))
      return Error{"sheet",
                   fmt::format("the name {} is not UTF-8, or holds a NUL", in_quotes(caption))};
    if (caption.empty() || strip_ == 0) continue;
    const glm::ivec2 at = corner(place);
    lay(sheet_,
        sheet_picture(caption_scene(letters(), caption, double(width_) / strip_),
                      {.width = width_, .height = strip_}),
        at.x, at.y + height_);
  }
  return std::move(sheet_);
}

Expected<Image> captioned_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout) {
  const auto named =
      std::ranges::find_if(cells, [](const SheetCell& c) { return !c.caption.empty(); });
  auto sheet =
      CaptionedSheet::begin(int(cells.size()), named == cells.end() ? cells[0] : *named, layout);
  if (!sheet) return sheet.error();
  for (std::size_t i = 0; i < cells.size(); ++i) sheet->put(int(i), cells[i]);
  return (*std::move(sheet)).finish();
}

}  // namespace mien::command
