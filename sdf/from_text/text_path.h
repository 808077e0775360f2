#pragma once
// A line of text as one closed path: labels, legends, colour bars.
//
//   build.layer("label", text_area(build, "0.5 × brow", 12, {0, -4}, {.anchor = TextAnchor::middle}),
//               {ink});

#include <mien/font.h>
#include <mien/lettering.h>
#include <mien/scene.h>

#include <string_view>

namespace mien {

/// Which part of the line lies at its origin.
enum class TextAnchor { start, middle, end };

struct TextStyle {
  TextAnchor anchor = TextAnchor::start;
  bool y_up = true;  ///< as the canvas has it
  Font font = Font::shipped();
};

/// How long the line is, for a size of 1: the pen's way, kerning included.
MIEN_API double text_length(std::string_view text, const TextStyle& style = {});

/// UTF-8 (what is none counts as U+FFFD), left to right, with kerning; line breaks and other control
/// characters are left out. `size` is the font's em, > 0: capitals are about 0.73 of it high.
/// `origin` is on the base line. Loops keep the font's turns (mirrored where y points down), filled
/// by the nonzero rule; a line without any outline is a path without loops.
MIEN_API Path text_path(std::string_view text, double size, glm::dvec2 origin,
                        const TextStyle& style = {});

/// The same as an area of a scene under construction.
MIEN_API Area text_area(SceneBuilder& build, std::string_view text, double size, glm::dvec2 origin,
                        const TextStyle& style = {});

/// The shipped font, for makers of scenes that write.
MIEN_API Lettering shipped_lettering();

}  // namespace mien
