#pragma once
// A node of a JSON tree as text again.

#include "lib/file/json/reading.h"

#include <string>

namespace mien {

/// On one line. Not recursive beyond the nesting that its tree allowed.
std::string json_copy(const Reading& in, const JsonNode& node);

}  // namespace mien
