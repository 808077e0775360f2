#pragma once
// What writes WebP and GIF, loaded when it is needed.

#include <mien/expected.h>
#include "tools/mien/film/film_module.h"

namespace mien::command {

/// The error's `where` is left empty. On any thread.
Expected<const FilmModule*> film_module();

}  // namespace mien::command
