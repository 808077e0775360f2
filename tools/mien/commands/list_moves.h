#pragma once
// mien list --moves NAME.

#include <string_view>

namespace mien::command {

/// Prints the rows of a standard name, of each set that has it. Complains about a name that none has.
int list_moves(std::string_view name);

}  // namespace mien::command
