#include "tools/mien/output/contact_sheet.h"
#include <mien/render.h>
#include "sdf/from_face/caption.h"
#include "sdf/from_face/heat.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace mien::command {
namespace {

std::uint8_t* row_of(Image& image, int y) {
  return reinterpret_cast<std::uint8_t*>(image.bytes.data()) + image.stride() * std::size_t(y);
}

Image blank(int width, int height, std::array<std::uint8_t, 3> color) {
  Image image{.width = width, .height = height};
  image.bytes.resize(image.stride() * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = row_of(image, y) + 4 * x;
      std::copy(color.begin(), color.end(), pixel);
      pixel[3] = 255;
    }
  return image;
}

}  // namespace

Image contact_sheet(const std::vector<Image>& pictures, int columns, int gap,
                    std::array<std::uint8_t, 3> color) {
  if (pictures.empty()) return blank(1, 1, color);
  const int width = pictures[0].width, height = pictures[0].height, count = int(pictures.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  Image sheet = blank(columns * (width + gap) + gap, rows * (height + gap) + gap, color);
  for (int i = 0; i < count; ++i) {
    const int x = gap + i % columns * (width + gap), y = gap + i / columns * (height + gap);
    for (int r = 0; r < height; ++r)
      std::memcpy(row_of(sheet, y + r) + 4 * x, pictures[std::size_t(i)].row(r),
                  4 * std::size_t(width));
  }
  return sheet;
}

Image captioned(const Image& picture, const std::string& word) {
  const int strip = std::max(12, picture.height / 14);
  const double aspect = double(picture.width) / strip;
  SceneBuilder build({{{0, 0}, {aspect, 1}}, true}, color_from_srgb255(24, 26, 32));
  const double high = std::min(0.62, 0.92 * aspect / std::max(caption_width(letters(), word), 1.0));
  draw_caption(build, letters(), word,
               {0.5 * (aspect - high * caption_width(letters(), word)), 0.5 - 0.55 * high}, high,
               true, color_from_srgb255(226, 226, 220));
  const Image below =
      sheet_picture(std::move(build).finish(), {.width = picture.width, .height = strip});
  Image out{.width = picture.width, .height = picture.height + strip};
  out.bytes = picture.bytes;
  out.bytes.insert(out.bytes.end(), below.bytes.begin(), below.bytes.end());
  return out;
}

Image difference_picture(const Image& a, const Image& b, int most) {
  Image out = blank(a.width, a.height, {0, 0, 0});
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      int worst = 0;
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(a.row(y)[4 * x + c] - b.row(y)[4 * x + c]));
      if (worst == 0) continue;
      const auto heat = heat_rgb(std::min(double(worst) / std::max(most, 1), 1.0));
      std::copy(heat.begin(), heat.end(), row_of(out, y) + 4 * x);
    }
  return out;
}

LevelDifference level_difference(const Image& a, const Image& b) {
  LevelDifference found;
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int d = std::abs(a.row(y)[4 * x + c] - b.row(y)[4 * x + c]);
        found.max = std::max(found.max, d);
        sum += double(d) * d;
      }
  found.rms = std::sqrt(sum / (3.0 * a.width * a.height));
  return found;
}

}  // namespace mien::command
