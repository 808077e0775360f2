#pragma once
// A node of a JSON tree as text again.

#include "lib/file/json/json_tree.h"

#include <string>

namespace mien {

/// Appends it, on one line. No deeper than the nesting that its tree allowed.
void add_json(const JsonTree& tree, const JsonNode& node, std::string& to);

}  // namespace mien
