#pragma once
// Recipes in and out: face files of format version 2.

#include <mien/expected.h>
#include <mien/recipe.h>
#include "lib/file/json/reading.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace mien {

/// Reads the recipe of a face file of format version 2, and the parts of its own that lie in `folder`, of at most
/// `in.limits` bytes each; null: it is of no file and can have none. Refuses what the library has not, at its place.
Recipe read_recipe(Reading& in, const JsonNode& root, const std::filesystem::path* folder);

/// The recipe of a face file's text, without parts of its own. The error is a sentence with its place in `name`; a face
/// in full, format version 1, has none.
Expected<Recipe> read_recipe_text(std::string_view text, std::string_view name);

/// The recipe of a face file. The error is a sentence with its place, as read_face has them; a face in full, format
/// version 1, has none.
Expected<Recipe> read_recipe_file(const std::filesystem::path& path,
                                  std::vector<Error>* warnings = nullptr);

}  // namespace mien
