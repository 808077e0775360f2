#include "sdf/from_face/caption.h"

#include <algorithm>
#include <string>
#include <utility>

namespace mien {
namespace {

constexpr double kRise = 8, kAdvance = 6, kHalfWidth = 0.42;  ///< in steps of the letters' grid

/// The lines of a letter: points as two digits, x from 0 to 4 and y from 0 (descender) over 2 (baseline)
/// and 6 to 8 (ascender).
std::string_view lines_of(char letter) {
  constexpr std::string_view kLetters[] = {"46 42,45 26 05 03 22 43",
                                           "08 02,05 26 45 43 22 03",
                                           "45 26 05 03 22 43",
                                           "48 42,45 26 05 03 22 43",
                                           "04 44 45 26 05 03 22 43",
                                           "48 38 27 22,16 46",
                                           "46 41 20 01,45 26 05 03 22 43",
                                           "08 02,05 26 45 42",
                                           "26 22,28 28",
                                           "36 31 10,38 38",
                                           "08 02,46 04 42",
                                           "28 22",
                                           "06 02,05 16 25 22,25 36 45 42",
                                           "06 02,05 26 45 42",
                                           "26 45 43 22 03 05 26",
                                           "06 00,05 26 45 43 22 03",
                                           "46 40,45 26 05 03 22 43",
                                           "06 02,04 26 46",
                                           "45 36 16 05 14 34 43 32 12 03",
                                           "18 13 22 42,06 36",
                                           "06 03 22 43,46 42",
                                           "06 22 46",
                                           "06 12 25 32 46",
                                           "06 42,46 02",
                                           "06 23,46 10",
                                           "06 46 02 42"};
  constexpr std::string_view kDigits[] = {
      "28 47 43 22 03 07 28",       "07 28 22",    "07 28 47 46 02 42",
      "08 48 25 44 43 22 03",       "32 38 04 44", "48 08 05 35 44 43 22 03",
      "47 28 06 03 22 43 44 25 04", "08 48 12",    "25 07 28 47 25 03 22 43 25",
      "03 22 44 47 28 07 06 25 46"};
  if (letter >= 'a' && letter <= 'z') return kLetters[letter - 'a'];
  if (letter >= 'A' && letter <= 'Z') return kLetters[letter - 'A'];
  if (letter >= '0' && letter <= '9') return kDigits[letter - '0'];
  switch (letter) {
    case '.':
      return "22 22";
    case '-':
      return "14 34";
    case '_':
      return "01 41";
    case '/':
      return "01 48";
    case '%':
      return "48 02,07 07,43 43";
  }
  return {};
}

}  // namespace

double caption_width(std::string_view text) {
  return (double(text.size()) * kAdvance - 2) / kRise;
}

void draw_caption(SceneBuilder& build, std::string_view text, glm::dvec2 at, double height,
                  bool y_up, const Color& ink) {
  const double step = height / kRise, up = y_up ? step : -step;
  Area all;
  const auto add = [&](Shape shape) {
    const Area area = build.shape(std::move(shape));
    all = all.node < 0 ? area : build.either(all, area);
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const double left = at.x + double(i) * kAdvance * step;
    Polyline line{{}, kHalfWidth * step};
    const std::string_view lines = lines_of(text[i]);
    for (std::size_t n = 0; n + 1 < lines.size(); n += 3) {
      line.points.push_back({left + step * (lines[n] - '0'), at.y + up * (lines[n + 1] - '0')});
      const bool last = n + 2 >= lines.size() || lines[n + 2] == ',';
      if (last) add(std::exchange(line, {{}, kHalfWidth * step}));
    }
  }
  if (all.node >= 0) build.layer(std::string{text}, all, {.color = ink});
}

Scene caption_scene(std::string_view text, double aspect) {
  SceneBuilder build({.box = {{0, 0}, {aspect, 1}}, .y_up = true}, {1, 1, 1, 1});
  const double height = std::min(0.62, 0.92 * aspect / std::max(caption_width(text), 1.0));
  const double width = height * caption_width(text);
  draw_caption(build, text, {0.5 * (aspect - width), 0.5 * (1 - 1.1 * height)}, height, true,
               {0.02, 0.02, 0.03, 1});
  return std::move(build).finish();
}

}  // namespace mien
