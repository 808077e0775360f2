#pragma once
// What a file of data says that it is.

#include "lib/file/json/reading.h"

#include <string_view>

namespace mien::command {

/// Refuses a file whose "format" is another, or whose "format_version" is not 1.
void expect_format(const Reading& in, const JsonNode& root, std::string_view format);

}  // namespace mien::command
