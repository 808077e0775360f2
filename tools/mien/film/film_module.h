#pragma once
// What giflib and libwebp write, as a module that is loaded when such a film is made: so neither comes with every process of
// the command.

#include <mien/version.h>
#include "render/image/file/written_file.h"
#include "tools/mien/film/film_palette.h"
#include "tools/mien/film/picture_series.h"

namespace mien::command {

/// Without loss.
MadeSeries webp_series(const PutBytes& put, const FilmPlan& plan);
/// With one palette for the whole film.
MadeSeries gif_series(const PutBytes& put, const FilmPlan& plan, FilmPalette palette);

struct FilmModule {
  decltype(&webp_series) webp;
  decltype(&gif_series) gif;
};

using FilmModuleEntry = const FilmModule* (*)();
inline constexpr char kFilmModuleEntry[] = "mien_film_module";
/// It carries mien's version: both sides are always of the same one.
inline constexpr char kFilmModuleFile[] = "mien-films-" MIEN_VERSION_STRING ".so";

}  // namespace mien::command
