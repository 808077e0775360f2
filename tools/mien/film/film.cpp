#include "tools/mien/film/film.h"
#include "render/image/file/output_path.h"
#include "render/image/file_type.h"
#include "tools/mien/film/ffmpeg_film.h"
#include "tools/mien/film/picture_film.h"

#include <utility>

namespace mien::command {

std::optional<FilmType> film_type(const std::string& path) {
  const std::string extension = lower_extension(path);
  const std::pair<const char*, FilmType> known[] = {{".mp4", FilmType::mp4},
                                                    {".webm", FilmType::webm},
                                                    {".webp", FilmType::webp},
                                                    {".apng", FilmType::apng},
                                                    {".gif", FilmType::gif}};
  for (const auto& [name, type] : known)
    if (extension == name) return type;
  return {};
}

bool holds_transparency(FilmType type) {
  return type != FilmType::mp4;
}

bool holds_sound(FilmType type) {
  return type == FilmType::mp4 || type == FilmType::webm;
}

Expected<std::unique_ptr<FilmWriter>> begin_film(const std::string& path, const FilmPlan& plan) {
  const auto target = find_output_path(path);
  if (!target) return target.error();
  if (target->stream) return Error{path, "a film needs a file that can be replaced"};
  auto file = AtomicFile::begin(target->path);
  if (!file) return file.error();
  return holds_sound(plan.type) ? ffmpeg_film(*std::move(file), path, plan)
                                : picture_film(*std::move(file), path, plan);
}

}  // namespace mien::command
