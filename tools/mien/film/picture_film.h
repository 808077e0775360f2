#pragma once
// Films that are animated pictures: APNG, WebP, GIF.
//
// A frame that is equal to the one before makes that one last longer. Times are whole ticks of the format, and every frame
// begins at the tick nearest to its moment, so roundings never add up. Frames that a format cannot show for so short a time are
// left out.

#include "render/image/file/atomic_file.h"
#include "tools/mien/film/film.h"

#include <memory>
#include <string>

namespace mien::command {

/// `name`: of the film, for errors.
Expected<std::unique_ptr<FilmWriter>> picture_film(AtomicFile file, const std::string& name,
                                                   const FilmPlan& plan);

}  // namespace mien::command
