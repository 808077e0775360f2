#include "lib/file/json/json_text.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// The code point of `text`, one well-formed character.
unsigned code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return unsigned(static_cast<unsigned char>(text[i])); };
  if (text.size() == 1) return byte(0);
  unsigned code = byte(0) & (0xffu >> (text.size() + 1));
  for (std::size_t i = 1; i < text.size(); ++i) code = code << 6 | (byte(i) & 0x3f);
  return code;
}

/// Stands for itself.
bool is_plain(char c) {
  return c >= 0x20 && c < 0x7f && c != '"' && c != '\\';
}

std::string escaped(unsigned code) {
  if (code == '"' || code == '\\') return fmt::format("\\{}", char(code));
  if (code >= 0x20 && code < 0x7f) return std::string(1, char(code));
  if (code < 0x10000) return fmt::format("\\u{:04x}", code);
  code -= 0x10000;
  return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + (code >> 10), 0xdc00 + (code & 0x3ff));
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const auto plain =
        std::size_t(std::find_if_not(text.begin(), text.end(), is_plain) - text.begin());
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const int length = utf8_length(text);
    out += escaped(length ? code_point(text.substr(0, std::size_t(length))) : 0xfffd);
    text.remove_prefix(std::size_t(length ? length : 1));
  }
  return out + "\"";
}

std::string well_formed(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto length = std::size_t(utf8_length(text));
    if (length)
      out += text.substr(0, length);
    else
      out += "\xEF\xBF\xBD";
    text.remove_prefix(length ? length : 1);
  }
  return out;
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace mien
