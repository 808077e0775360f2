#include <mien/text_path.h>
#include "character_private.h"

#include <string>
#include <utility>

namespace mien {
namespace {

std::u32string characters(std::string_view text) {
  std::u32string all;
  while (!text.empty()) {
    const char32_t c = next_character(text);
    if (c >= 0x20 && !(c >= 0x7f && c < 0xa0)) all += c;
  }
  return all;
}

double kerning_before(const Font& font, const std::u32string& text, std::size_t i) {
  return i > 0 ? font.kerning(text[i - 1], text[i]) : 0.0;
}

}  // namespace

double text_length(std::string_view text, const TextStyle& style) {
  const std::u32string all = characters(text);
  double length = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    length += kerning_before(style.font, all, i) + style.font.glyph(all[i]).advance;
  return length;
}

Path text_path(std::string_view text, double size, glm::dvec2 origin, const TextStyle& style) {
  const double before = style.anchor == TextAnchor::start ? 0.0 : text_length(text, style);
  double pen = style.anchor == TextAnchor::middle ? -0.5 * before : -before;
  const glm::dvec2 scale{size, style.y_up ? size : -size};
  Path path;
  const std::u32string all = characters(text);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Glyph glyph = style.font.glyph(all[i]);
    pen += kerning_before(style.font, all, i);
    const auto place = [&](glm::dvec2 p) { return origin + scale * (p + glm::dvec2{pen, 0}); };
    for (Path::Loop& loop : glyph.loops) {
      for (QuadBezier& side : loop.sides) side = {place(side.p0), place(side.p1), place(side.p2)};
      path.loops.push_back(std::move(loop));
    }
    pen += glyph.advance;
  }
  return path;
}

Area text_area(SceneBuilder& build, std::string_view text, double size, glm::dvec2 origin,
               const TextStyle& style) {
  return build.shape(text_path(text, size, origin, style));
}

Lettering shipped_lettering() {
  const Font font = Font::shipped();
  return {.path =
              [font](std::string_view text, double size, glm::dvec2 origin, bool y_up) {
                return text_path(text, size, origin, {.y_up = y_up, .font = font});
              },
          .length = [font](std::string_view text) { return text_length(text, {.font = font}); },
          .ascent = font.ascent(),
          .descent = font.descent()};
}

}  // namespace mien
