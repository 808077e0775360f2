#pragma once
// The little JSON that mien writes. Pure ASCII: it is also stored where only Latin-1 is allowed.

#include <string>
#include <string_view>

namespace mien {

/// In quotes, with everything but printable ASCII escaped. Broken UTF-8 becomes U+FFFD.
std::string json_string(std::string_view text);

/// What json_string's text reads back as: broken UTF-8 becomes U+FFFD.
std::string well_formed(std::string_view text);

/// The shortest text that reads back as the same number; null if it is not finite.
std::string json_number(double value);

}  // namespace mien
