#include "tools/mien/film/film_module.h"

extern "C" __attribute__((visibility("default"))) const mien::command::FilmModule*
mien_film_module() {
  static constexpr mien::command::FilmModule verbs{&mien::command::webp_series,
                                                   &mien::command::gif_series};
  return &verbs;
}
