#include "tools/mien/batch/variable.h"
#include <mien/face_code.h>
#include <mien/recipe.h>

#include <fmt/format.h>

namespace mien::command {
namespace {

constexpr int kRegionTile = 256;  // [px] of TIFF's tiles (render/image/tiff)

int digits_of(long number) {
  return int(fmt::format("{}", number).size());
}

/// Where the i-th of `parts` parts of a side begins.
int cut_at(int side, int parts, int i) {
  const int place = int(std::int64_t(side) * i / parts);
  return i < parts && side / parts >= kRegionTile ? place / kRegionTile * kRegionTile : place;
}

}  // namespace

std::string Variable::text(long i) const {
  switch (kind) {
    case Kind::words:
    case Kind::stimuli:
      return words[std::size_t(i)];
    case Kind::numbers:
    case Kind::frames:
      return fmt::format("{:0{}}", first + i, digits_of(first + count - 1));
    case Kind::people:
      return face_code_text({.seed = seed_from_word(fmt::format("{}/{}", seed, i)), .held = {}});
    case Kind::regions:
      break;
  }
  return fmt::format("r{:0{}}c{:0{}}", i / columns, digits_of(rows - 1), i % columns,
                     digits_of(columns - 1));
}

std::vector<std::string> Variable::arguments(long i) const {
  if (kind == Kind::frames) return {"--frames", fmt::format("{0}-{0}", first + i)};
  if (kind != Kind::regions) return {};
  const PixelRect& rect = rects[std::size_t(i)];
  return {"--region", fmt::format("{},{},{},{}", rect.x, rect.y, rect.width, rect.height)};
}

std::vector<PixelRect> cut_regions(int width, int height, int columns, int rows) {
  std::vector<PixelRect> rects;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x = cut_at(width, columns, column), y = cut_at(height, rows, row);
      rects.push_back(
          {x, y, cut_at(width, columns, column + 1) - x, cut_at(height, rows, row + 1) - y});
    }
  return rects;
}

}  // namespace mien::command
