#pragma once
// Films by ffmpeg: frames go through a pipe into its process, which writes the file.

#include "render/image/file/atomic_file.h"
#include "tools/mien/film/film.h"

#include <memory>
#include <string>

namespace mien::command {

/// An mp4 or a webm. `name`: of the film, for errors. Errors: ffmpeg is not installed (names the package), sides that the type
/// cannot have.
Expected<std::unique_ptr<FilmWriter>> ffmpeg_film(AtomicFile file, const std::string& name,
                                                  const FilmPlan& plan);

}  // namespace mien::command
