#include "sdf/from_face/caption.h"

#include <algorithm>
#include <string>
#include <utility>

namespace mien {

double caption_width(const Lettering& letters, std::string_view text) {
  return letters.length ? letters.length(text) / (letters.ascent + letters.descent) : 0;
}

void draw_caption(SceneBuilder& build, const Lettering& letters, std::string_view text,
                  glm::dvec2 at, double height, bool y_up, const Color& ink) {
  if (!letters.path) return;
  const double size = height / (letters.ascent + letters.descent);
  at.y += (y_up ? 1 : -1) * letters.descent * size;
  Path line = letters.path(text, size, at, y_up);
  if (!line.loops.empty())
    build.layer(std::string{text}, build.shape(std::move(line)), {.color = ink});
}

Scene caption_scene(const Lettering& letters, std::string_view text, double aspect) {
  SceneBuilder build({.box = {{0, 0}, {aspect, 1}}, .y_up = true}, {1, 1, 1, 1});
  const double unit = caption_width(letters, text);
  const double height = std::min(0.72, 0.92 * aspect / std::max(unit, 1.0));
  draw_caption(build, letters, text, {0.5 * (aspect - height * unit), 0.5 * (1 - height)}, height,
               true, {0.02, 0.02, 0.03, 1});
  return std::move(build).finish();
}

}  // namespace mien
