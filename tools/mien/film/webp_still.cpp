#include "tools/mien/film/webp_still.h"
#include "tools/mien/film/load_film_module.h"

namespace mien::command {

Expected<std::string> webp_still(const Image& image) {
  const auto module = film_module();
  if (!module) return module.error();
  std::string bytes;
  const PutBytes put = [&](const void* more, std::size_t size) -> Expected<Done> {
    bytes.append(static_cast<const char*>(more), size);
    return Done{};
  };
  const auto series = (*module)->webp(put, {.type = FilmType::webp,
                                            .width = image.width,
                                            .height = image.height,
                                            .transparent = !image.opaque,
                                            .frames = 1});
  if (!series) return series.error();
  const PixelRect whole{0, 0, image.width, image.height};
  if (auto done = (*series)->put(image, whole, (*series)->ticks().shortest); !done)
    return done.error();
  if (auto done = (*series)->finish(); !done) return done.error();
  return bytes;
}

}  // namespace mien::command
