#pragma once
// One person becoming another.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/recipe.h>

#include <optional>

namespace mien {

/// From one recipe (0) to another (1). Numbers and colours go evenly, colours as they are perceived; a part cannot, so
/// it changes at a place: `parts_at`, or each part at a place of its own, the same as `code_between` has. The style
/// changes half-way, or at `parts_at`. The error names what one of them has and this version does not know.
MIEN_API Expected<Recipe> recipe_between(const Recipe& from, const Recipe& to, double at,
                                         std::optional<double> parts_at = {});

}  // namespace mien
