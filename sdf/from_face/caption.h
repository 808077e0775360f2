#pragma once
// Small words for sheets and debug pictures, in pen lines. Lower case, digits and . - _ / % only; other
// characters are left blank.

#include <mien/api.h>
#include <mien/scene.h>

#include <string_view>

namespace mien {

/// Width of a caption whose letters, from descender to ascender, are 1 high.
MIEN_API double caption_width(std::string_view text);

/// Draws `text` from the point where its descenders begin, to the right, letters `height` high, as one
/// layer.
MIEN_API void draw_caption(SceneBuilder& build, std::string_view text, glm::dvec2 at, double height,
                           bool y_up, const Color& ink);

/// A strip 1 high and `aspect` wide with the caption in its middle.
MIEN_API Scene caption_scene(std::string_view text, double aspect);

}  // namespace mien
