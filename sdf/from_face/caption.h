#pragma once
// Small words for sheets and debug pictures.

#include <mien/lettering.h>
#include <mien/scene.h>

#include <string_view>

namespace mien {

/// Width of a caption whose letters, from descender to ascender, are 1 high.
double caption_width(const Lettering& letters, std::string_view text);

/// Writes `text` from the point where its descenders begin, to the right, letters `height` high, as one
/// layer.
void draw_caption(SceneBuilder& build, const Lettering& letters, std::string_view text,
                  glm::dvec2 at, double height, bool y_up, const Color& ink);

/// A strip 1 high and `aspect` wide with the caption in its middle.
Scene caption_scene(const Lettering& letters, std::string_view text, double aspect);

}  // namespace mien
