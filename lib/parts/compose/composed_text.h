#pragma once
// A composed face as the text of its file.

#include "lib/file/json/json_tree.h"

#include <string>

namespace mien {

/// A line for each member, each feature and each group of muscles.
std::string composed_text(const JsonTree& face);

}  // namespace mien
