#include "tools/mien/film/frame_names.h"

#include <fmt/format.h>

namespace mien::command {

std::string FrameNames::of(long frame) const {
  return before + fmt::format("{:0{}}", frame, digits) + after;
}

Expected<std::optional<FrameNames>> read_frame_names(const std::string& pattern) {
  const Error wrong{fmt::format("-o {}", pattern),
                    "expected one place for the frame's number, as in %05d"};
  FrameNames names;
  bool found = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    std::string& part = found ? names.after : names.before;
    if (pattern[i] != '%') {
      part += pattern[i];
      continue;
    }
    if (pattern.compare(i, 2, "%%") == 0) {
      part += '%';
      ++i;
      continue;
    }
    const std::size_t end = pattern.find_first_not_of("0123456789", i + 1);
    if (found || end == std::string::npos || pattern[end] != 'd' || end - i > 3) return wrong;
    if (end > i + 1) names.digits = std::stoi(pattern.substr(i + 1, end - i - 1));
    found = true;
    i = end;
  }
  if (!found) return std::optional<FrameNames>{};
  return std::optional(names);
}

}  // namespace mien::command
