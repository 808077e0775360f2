#pragma once
#include <string_view>

namespace mien {

inline constexpr char32_t kReplacement = 0xfffd;  ///< stands for what is no UTF-8

/// Takes one character off the front of UTF-8; an invalid one takes a byte.
char32_t next_character(std::string_view& text);

}  // namespace mien
