#pragma once
// Letters for faces with text in them.

#include <mien/api.h>
#include <mien/font.h>
#include <mien/letters.h>

namespace mien {

/// Letters of a font. What it lacks, control characters among it, is an error that names it.
MIEN_API Letters letters_of(const Font& font);

/// Those of the shipped font.
MIEN_API Letters shipped_letters();

}  // namespace mien
