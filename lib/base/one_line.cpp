#include "lib/base/one_line.h"

#include <fmt/format.h>

namespace mien {

int utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto at = [&](std::size_t i) {
    return i < text.size() ? int(static_cast<unsigned char>(text[i])) : 0;
  };
  const int a = at(0), b = at(1);
  const auto tail = [&](std::size_t i) { return (at(i) & 0xC0) == 0x80; };
  if (a < 0x80) return 1;
  if (a >= 0xC2 && a <= 0xDF) return tail(1) ? 2 : 0;
  if (a >= 0xE0 && a <= 0xEF) {  // no overlong forms, no surrogates
    const bool fits = !(a == 0xE0 && b < 0xA0) && !(a == 0xED && b > 0x9F);
    return fits && tail(1) && tail(2) ? 3 : 0;
  }
  if (a >= 0xF0 && a <= 0xF4) {  // up to U+10FFFF
    const bool fits = !(a == 0xF0 && b < 0x90) && !(a == 0xF4 && b > 0x8F);
    return fits && tail(1) && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line;
  while (!text.empty()) {
    if (line.size() >= longest) return line + "…";
    const int length = utf8_length(text);
    const auto c = static_cast<unsigned char>(text[0]);
    if (length == 0 || c < 0x20 || c == 0x7F) {
      line += fmt::format("\\x{:02X}", int(c));
      text.remove_prefix(1);
    } else {
      line += text.substr(0, std::size_t(length));
      text.remove_prefix(std::size_t(length));
    }
  }
  return line;
}

std::string in_quotes(std::string_view text) {
  return '"' + one_line(text, 60) + '"';
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const int length = utf8_length(text);
    if (length == 0 || text.front() == '\0') return false;
    text.remove_prefix(std::size_t(length));
  }
  return true;
}

}  // namespace mien
