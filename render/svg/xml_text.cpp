#include "render/svg/xml_text.h"
#include "lib/base/one_line.h"

namespace mien {
namespace {

/// Appended for what cannot be said.
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The length of the UTF-8 character that `text` begins with, or 0 where it is none, or none that XML allows.
std::size_t xml_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x20 && first != '\t' && first != '\n') return 0;
  if (text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF"))
    return 0;  // U+FFFE, U+FFFF
  return std::size_t(utf8_length(text));
}

bool may_stand_in_id(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == '_';
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string made;
  while (!text.empty()) {
    const std::size_t length = xml_character(text);
    const std::string_view one = text.substr(0, length);
    if (length == 0)
      made += kReplacement;
    else if (one == "&")
      made += "&amp;";
    else if (one == "<")
      made += "&lt;";
    else if (one == ">")
      made += "&gt;";
    else if (one == "\"")
      made += "&quot;";
    else
      made += one;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return made;
}

XmlIds::XmlIds(std::string_view prefix) {
  for (const char c : prefix) prefix_ += may_stand_in_id(c) ? c : '_';
}

std::string XmlIds::unique(std::string_view name) {
  std::string id = prefix_;
  for (const char c : name) id += may_stand_in_id(c) ? c : '_';
  const bool begins = !id.empty() && (id[0] == '_' || (id[0] | 32) >= 'a');  // a letter
  if (!begins) id.insert(0, 1, '_');
  std::string one = id;
  while (!taken_.try_emplace(one, 1).second) one = id + "-" + std::to_string(++taken_[id]);
  return one;
}

}  // namespace mien
