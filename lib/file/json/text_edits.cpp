#include "lib/file/json/text_edits.h"

#include <algorithm>

namespace mien {
namespace {

/// The end of the string that begins at `at`.
std::size_t string_end(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\';
  return std::min(at + 1, text.size());
}

}  // namespace

std::size_t json_end(std::string_view text, std::size_t begin) {
  const auto is_one_of = [&](std::size_t at, std::string_view signs) {
    return signs.find(text[at]) != std::string_view::npos;
  };
  std::size_t depth = 0, at = begin;
  while (at < text.size()) {
    if (text[at] == '"') {
      at = string_end(text, at);
    } else if (is_one_of(at, "[{")) {
      ++at, ++depth;
      continue;
    } else if (is_one_of(at, "]}")) {
      ++at, --depth;
    } else if (is_one_of(at, " \t\n\r,:")) {
      ++at;
      continue;
    } else {
      at = std::min(text.find_first_of(" \t\n\r,:[]{}", at), text.size());
    }
    if (depth == 0) break;
  }
  return at;
}

std::string TextEdits::text(std::size_t begin, std::size_t end) const {
  std::vector<const Edit*> order;
  for (const Edit& edit : edits_)
    if (edit.begin >= begin && edit.end <= end) order.push_back(&edit);
  std::stable_sort(order.begin(), order.end(),
                   [](const Edit* a, const Edit* b) { return a->begin < b->begin; });
  std::string made;
  for (const Edit* edit : order) {
    made.append(text_.substr(begin, edit->begin - begin)).append(edit->by);
    begin = edit->end;
  }
  return made.append(text_.substr(begin, end - begin));
}

}  // namespace mien
