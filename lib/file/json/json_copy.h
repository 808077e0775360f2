#pragma once
// A node of a JSON tree as text again.

#include "lib/file/json/reading.h"

#include <functional>
#include <optional>
#include <string>

namespace mien {

/// Text that stands for a node instead of its own; nothing: its own.
using JsonReplacement = std::function<std::optional<std::string>(const JsonNode&)>;

/// On one line. No deeper than the nesting that its tree allowed.
std::string json_copy(const Reading& in, const JsonNode& node, const JsonReplacement& replace = {});

}  // namespace mien
