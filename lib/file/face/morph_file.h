#pragma once
// Morph targets as files: shapes of a face that are made from other face files and kept beside it.
//
//   {"format": "mien-morphs", "format_version": 1, "face": "toon",
//    "poses": {"smile": {"range": [-100, 100], "slices": {"mouth/spine/0": [-0.168, -0.33], …}}}}
//
// "poses" is what a face file has under the same key. Only slices that differ are kept, as the
// target's own numbers in the shortest form that reads back the same: at weight 1 the face IS the
// target, bit for bit.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A face in another shape, and the name of that shape.
struct MorphTarget {
  std::string name;
  Face face;
};

/// The file's text. Errors: a target whose numbers have other names or sizes than the rest face's;
/// two targets of one name; a name that no pose may have.
MIEN_API Expected<std::string> morph_text(const Face& rest,
                                          const std::vector<MorphTarget>& targets);

/// The face with a file's targets added to its poses. Errors as read_face's: unknown names, numbers
/// too few or many, a name that the face has already.
MIEN_API Expected<Face> read_morphs(const Face& face, const std::filesystem::path& path);
MIEN_API Expected<Face> read_morphs_text(const Face& face, std::string_view text,
                                         std::string_view name = "morphs");

}  // namespace mien
