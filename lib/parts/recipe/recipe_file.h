#pragma once
// Recipes in and out: face files of format version 2.

#include <mien/recipe.h>
#include "lib/file/json/reading.h"

namespace mien {

/// Reads the recipe of a face file of format version 2; refuses what no edition has, at its place.
Recipe read_recipe(Reading& in, const JsonNode& root);

}  // namespace mien
