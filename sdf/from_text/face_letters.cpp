#include <mien/face_letters.h>
#include <mien/text_path.h>
#include "character_private.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace mien {
namespace {

/// [em] How high capitals are.
double height_of_capitals(const Font& font) {
  double high = 0;
  for (const Path::Loop& loop : font.glyph(U'H').loops)
    for (const QuadBezier& side : loop.sides) high = std::max(high, side.p0.y);
  return high > 0 ? high : 1;
}

/// "no letter for "\u2603" (U+2603)": what cannot be seen is named by its number alone.
std::string lacking(std::string_view sign, char32_t character) {
  char number[16];
  std::snprintf(number, sizeof number, "U+%04X", unsigned(character));
  if (character < 0x20 || (character >= 0x7f && character < 0xa0) || character == kReplacement)
    return std::string("the font has no letter for the sign ") + number;
  return "the font has no letter for \"" + std::string(sign) + "\" (" + number + ")";
}

}  // namespace

Letters letters_of(const Font& font) {
  return
      [font, size = 1 / height_of_capitals(font)](std::string_view text) -> Expected<TextOutline> {
        for (std::string_view rest = text; !rest.empty();) {
          const std::string_view before = rest;
          const char32_t c = next_character(rest);
          if (c < 0x20 || c == kReplacement || !font.has(c))
            return Error{{}, lacking(before.substr(0, before.size() - rest.size()), c)};
        }
        const TextStyle style{.anchor = TextAnchor::middle, .font = font};
        TextOutline made{.loops = {}, .width = size * text_length(text, style)};
        for (Path::Loop& loop : text_path(text, size, {0, -0.5}, style).loops)
          made.loops.push_back(std::move(loop.sides));
        return made;
      };
}

Letters shipped_letters() {
  // The font is opened for faces with text in them alone.
  return [](std::string_view text) { return letters_of(Font::shipped())(text); };
}

}  // namespace mien
