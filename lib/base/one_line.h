#pragma once
// Foreign text inside a message: always one line, always short, always printable UTF-8.

#include <cstddef>
#include <string>
#include <string_view>

namespace mien {

/// The text with control characters and broken UTF-8 written as \xNN, cut after `longest` bytes
/// ("…").
std::string one_line(std::string_view text, std::size_t longest = 200);

/// one_line in double quotes, cut after 60 bytes.
std::string in_quotes(std::string_view text);

/// How many bytes the UTF-8 character at the front of `text` has; 0 if it is broken or text is
/// empty.
int utf8_length(std::string_view text);

/// Whether a text is UTF-8 all through, without NULs.
bool is_utf8(std::string_view text);

}  // namespace mien
