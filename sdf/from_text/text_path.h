#pragma once
// A line of text as one closed path, for labels, legends and colour bars.
//
//   build.layer("label", text_area(build, "0.5 × brow", 12, {0, -4}, {.anchor = TextAnchor::middle}),
//               {ink});

#include <mien/font.h>
#include <mien/lettering.h>
#include <mien/scene.h>

#include <string_view>

namespace mien {

/// Which part of the line is at its origin.
enum class TextAnchor { start, middle, end };

struct TextStyle {
  TextAnchor anchor = TextAnchor::start;
  bool y_up = true;  ///< as in the canvas
  Font font = Font::shipped();
};

/// The length of the line for a size of 1: the sum of advances, with kerning.
MIEN_API double text_length(std::string_view text, const TextStyle& style = {});

/// Sets UTF-8 from left to right, with kerning. Invalid bytes count as U+FFFD; line breaks and other
/// control characters are dropped. `size` is the font's em, > 0; capitals are about 0.73 of it high.
/// `origin` is on the baseline. Loops keep the font's orientation (mirrored where y points down) and are
/// filled by the nonzero rule. A line without any outline is a path without loops.
MIEN_API Path text_path(std::string_view text, double size, glm::dvec2 origin,
                        const TextStyle& style = {});

/// The same as an area of a scene under construction.
MIEN_API Area text_area(SceneBuilder& build, std::string_view text, double size, glm::dvec2 origin,
                        const TextStyle& style = {});

/// The shipped font, for functions that write into scenes.
MIEN_API Lettering shipped_lettering();

}  // namespace mien
