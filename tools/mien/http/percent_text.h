#pragma once
// Parts of addresses as the bytes that they stand for (RFC 3986, 2.1).

#include <optional>
#include <string>
#include <string_view>

namespace mien::command {

/// Nothing where a % has no two hexadecimal digits behind it. `form`: a + is a space, as forms write it.
std::optional<std::string> percent_decoded(std::string_view text, bool form = false);

/// The path of a target, "/a%20b" of "/a%20b?c=d", and what is asked of it, "c=d".
struct TargetParts {
  std::string_view path, query;
};
TargetParts target_parts(std::string_view target);

}  // namespace mien::command
