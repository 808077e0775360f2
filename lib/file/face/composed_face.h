#pragma once
// Faces out of parts: by a recipe, by a code.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>
#include <mien/letters.h>
#include <mien/recipe.h>

#include <string_view>

namespace mien {

/// The face of a recipe, as if it had been read from a file. The error names what is unknown or out of
/// range, with the nearest known name. No file is read: parts are compiled in. `letters`: what texts in parts of its own
/// are made with.
MIEN_API Expected<Face> face_from_recipe(const Recipe& recipe, const Letters& letters = {});

/// The face of a code, "AA7Q2-MKX4T-BY".
MIEN_API Expected<Face> face_from_code(std::string_view code);

}  // namespace mien
