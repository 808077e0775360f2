#pragma once
// A seed becomes a recipe. Every choice is keyed by the permanent number of what is chosen, so a part or a number more
// changes only the faces that get it.

#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

namespace mien {

/// The recipe of a code in this library; what it holds must be there.
Recipe sampled_recipe(const PartLibrary& library, const FaceCode& code);

/// How feminine (−1) or masculine (1) the person of a code leans. No recipe holds it: parts and numbers follow from it.
double sampled_lean(const PartLibrary& library, const FaceCode& code);

}  // namespace mien
