#pragma once
// Pictures in rows, each above its name.

#include <mien/expected.h>
#include <mien/image.h>

#include <optional>
#include <string>
#include <vector>

namespace mien::command {

/// A picture of a sheet and what is written below it; names are in the letters of letters.h.
struct SheetCell {
  std::string caption;
  Image image;  ///< opaque, 8 bits
};

/// How a sheet's pictures stand.
struct SheetLayout {
  int columns = 3;
  int gap = 0;  ///< [px] of white between pictures
};

/// --columns and --gap.
Expected<SheetLayout> read_sheet_layout(const std::optional<std::string>& columns,
                                        int default_columns, const std::optional<std::string>& gap);

/// Rows of pictures of one size on white, above their captions if there are
/// any. It is an error if the sheet would be larger than a GiB.
Expected<Image> captioned_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout);

}  // namespace mien::command
