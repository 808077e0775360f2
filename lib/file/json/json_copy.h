#pragma once
// A node of a JSON tree as text again.

#include "lib/file/json/json_tree.h"

#include <string>

namespace mien {

/// Appends the node's text, on one line. It is nested no deeper than its tree was allowed to be.
void add_json(const JsonTree& tree, const JsonNode& node, std::string& to);

}  // namespace mien
