#pragma once
// JavaScript's object literals, as data.

#include "lib/file/json/json_tree.h"

#include <string_view>

namespace mien {

/// Reads `text`, which must outlive the tree: comments, single quotes, bare keys, trailing commas,
/// `var NAME =` or `export const NAME =` before a literal, types of TypeScript. Nothing is executed: other
/// statements are passed over, and what computes inside a literal is an error. The root is an object with a
/// member for each name; "" for a literal that has none.
Expected<JsonTree> read_javascript(std::string_view text, std::string_view name,
                                   const FaceLimits& limits);

}  // namespace mien
