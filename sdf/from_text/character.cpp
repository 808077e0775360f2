#include "character_private.h"

namespace mien {

char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? unsigned(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  char32_t c = length == 1 ? first : first & (0x7fu >> length);
  bool good = length > 0;
  for (std::size_t i = 1; i < length; ++i) {
    good &= (byte(i) & 0xc0) == 0x80;
    c = c << 6 | (byte(i) & 0x3f);
  }
  // No overlong forms, no halves of UTF-16's pairs, nothing beyond the last plane.
  good &= !(length == 3 && c < 0x800) && !(length == 4 && (c < 0x10000 || c > 0x10ffff)) &&
          !(c >= 0xd800 && c < 0xe000);
  text.remove_prefix(good ? length : 1);
  return good ? c : kReplacement;
}

}  // namespace mien
