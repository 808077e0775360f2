#pragma once
// A node of a JSON tree as text again.

#include "lib/file/json/reading.h"

#include <functional>
#include <optional>
#include <string>

namespace mien {

/// The text to write for a node instead of its own; none: its own.
using JsonReplacement = std::function<std::optional<std::string>(const JsonNode&)>;

/// The node's text on one line. It is nested no deeper than its tree was allowed to be.
std::string json_copy(const Reading& in, const JsonNode& node, const JsonReplacement& replace = {});

}  // namespace mien
