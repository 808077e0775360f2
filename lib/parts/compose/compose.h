#pragma once
// A recipe becomes a face: parts are put on the topology, then nothing of them is left.

#include <mien/expected.h>
#include <mien/recipe.h>
#include "lib/file/json/json_tree.h"
#include "lib/parts/library/part_library.h"

#include <optional>

namespace mien {

/// What the recipe asks for that the library does not have; nothing if it has all.
std::optional<Error> wrong_in(const PartLibrary& library, const Recipe& recipe);

/// Families without a part in the recipe, and that need one, take their first.
Recipe completed(const PartLibrary& library, Recipe recipe);

/// The tree of a face file of format version 1, for a reader of trees: it never was text. The library must outlive it.
/// The error names what is unknown or out of range.
Expected<JsonTree> composed_face(const PartLibrary& library, const Recipe& recipe);

}  // namespace mien
