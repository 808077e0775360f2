#pragma once
// A recipe as a code says it: a value for every field, and the shortest code of them.

#include <mien/face_code.h>
#include <mien/recipe.h>

#include <cstdint>
#include <map>

namespace mien {

/// By the permanent number of a family or number, the part's or 1/1023 of the range. All of them are there.
using CodeFields = std::map<int, int>;

/// Numbers are taken to the nearest step. What the recipe does not say is as composing takes it: at rest, no part, or
/// the family's usual one.
CodeFields code_fields(const Recipe& recipe);

/// The shortest code of these fields with that seed.
FaceCode code_of_fields(const CodeFields& fields, std::uint64_t seed);

/// The code of a recipe: of its own code's seed if it has one. Names, styles and parts of one's own
/// are in no code.
/// The error names what is unknown or out of range.
Expected<FaceCode> code_of_recipe(const Recipe& recipe);

}  // namespace mien
