#pragma once
// What a style changes in a recipe before it is composed: parts that it has instead, numbers that it moves.
//
//   "parts"    {"background": "plain", "skin": null}                          null: none
//   "numbers"  {"eye.size": {"times": 1.1}, "smile": {"adds": 0.2}}           of the value, within the number's range

#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

namespace mien {

/// The recipe as its style draws it. Its style must be one of the library's. Refuses, at its place, what the library has not.
Recipe styled(const PartLibrary& library, Recipe recipe);

}  // namespace mien
