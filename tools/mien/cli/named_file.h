#pragma once
// "NAME=FILE", or FILE alone, whose name up to its first dot is the name.

#include <string>
#include <utility>

namespace mien::command {

std::pair<std::string, std::string> name_and_file(const std::string& text);

}  // namespace mien::command
