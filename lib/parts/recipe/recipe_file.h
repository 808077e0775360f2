#pragma once
// Recipes in and out: face files of format version 2.

#include <mien/expected.h>
#include <mien/recipe.h>
#include "lib/file/json/reading.h"

#include <string_view>
#include <vector>

namespace mien {

/// Reads the recipe of a face file of format version 2; refuses what no edition has, at its place.
Recipe read_recipe(Reading& in, const JsonNode& root);

/// The recipe of a face file. The error is a sentence with its place, as read_face has them; a face in full, format
/// version 1, has none.
Expected<Recipe> read_recipe_text(std::string_view text, std::string_view name,
                                  std::vector<Error>* warnings = nullptr);

}  // namespace mien
