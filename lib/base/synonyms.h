#pragma once
// What people call things, and what mien calls them. One table for all lists of names: emotions, muscles, controls,
// parts, styles, options, commands.

#include <span>
#include <string_view>

namespace mien {

/// What a word may mean, the likeliest first: names, or an option or argument with what
/// follows it, "--set yaw=DEGREES", "set: yaw". `word` is in lower case and without separators. Empty: no word of the table.
std::span<const std::string_view> meanings(std::string_view word);

}  // namespace mien
