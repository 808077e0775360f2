#pragma once
// The palette of a film that is not drawn yet.

#include "tools/mien/film/film.h"
#include "tools/mien/film/film_palette.h"

namespace mien::command {

/// Out of frames that are spread over the film. An error's `where` is left empty.
Expected<FilmPalette> sampled_palette(const FilmPlan& plan);

}  // namespace mien::command
