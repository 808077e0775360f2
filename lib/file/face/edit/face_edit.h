#pragma once
// A face file with other numbers, and nothing else changed: comments, order, white space and all other numbers keep
// every byte.
//
//   const auto edited = edit_face_text(text, {"brow.left/spine/1=-0.4,0.5", "palette/skin=#c98a5e"});
//   edited->text      // the file's text
//   edited->left      // names that the file cannot hold

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face_limits.h>
#include <mien/letters.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct EditedFace {
  std::string text;
  std::vector<std::string> left;  ///< names that no place of the file holds, as they were set
};

/// Puts values into a face file's text. `settings` are read as read_setting does, "NAME=VALUE"; later ones beat earlier
/// ones. Where the file writes both sides of a feature or an eye once and they are no longer each other's image, the
/// side that was set gets an object of its own: "left" or "right".
///   A file holds what it writes as numbers or as a colour: what has a pointer (face_pointers.h). Controls and expressions
/// are poses, and a recipe (format version 2) is made of parts: such names are left. Colours that are no "#rrggbb" become
/// lists of sRGB channels, within rounding of what was asked for; everything else reads back exactly.
///   Errors: those of read_face_text, for the text and for what would become of it; those of read_setting.
MIEN_API Expected<EditedFace> edit_face_text(std::string_view text,
                                             const std::vector<std::string>& settings,
                                             std::string_view name = "face",
                                             const FaceLimits& limits = {},
                                             const Letters& letters = {});

/// The same for a file, which is not written.
MIEN_API Expected<EditedFace> edit_face(const std::filesystem::path& path,
                                        const std::vector<std::string>& settings,
                                        const FaceLimits& limits = {}, const Letters& letters = {});

}  // namespace mien
