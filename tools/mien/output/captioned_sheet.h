#pragma once
// Pictures in rows, each above its name.

#include <mien/expected.h>
#include <mien/image.h>

#include <glm/vec2.hpp>
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

/// Rows of pictures of one size on white, above their captions if there are any. A picture is laid down as soon as it is
/// drawn, so a sheet of a thousand takes little more memory than its own pixels.
class CaptionedSheet {
 public:
  /// For so many pictures of the size of `first`, which has a caption if any of them has. It is an error if the
  /// sheet would be larger than a GiB.
  static Expected<CaptionedSheet> begin(int count, const SheetCell& first,
                                        const SheetLayout& layout);

  /// Lays a picture down. Those of different places may come at once, from many threads.
  void put(int place, SheetCell cell);
  /// The sheet with its captions; an error names one that cannot be written.
  Expected<Image> finish() &&;

 private:
  CaptionedSheet() = default;
  /// The left upper corner of a picture [px].
  glm::ivec2 corner(int place) const;

  Image sheet_;
  std::vector<std::string> captions_;
  int width_ = 0, height_ = 0, strip_ = 0, columns_ = 1, gap_ = 0;  ///< of a cell [px]; pictures
};

/// The same of pictures that are there.
Expected<Image> captioned_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout);

}  // namespace mien::command
