#pragma once
// Morph target files: other shapes of a face, made from other face files and kept beside it.
//
//   {"format": "mien-morphs", "format_version": 1, "face": "toon",
//    "poses": {"smile": {"range": [-100, 100], "slices": {"mouth/spine/0": [-0.168, -0.33], …}}}}
//
// "poses" has the form that it has in a face file. Only slices that differ are kept, with the target's
// own numbers in the shortest form that reads back exactly. At weight 1 the face is the target, bit for
// bit.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A face in another shape, with the name of that shape.
struct MorphTarget {
  std::string name;
  Face face;
};

/// The file's text. Errors: a target whose slices differ from the rest face's in name or size; two
/// targets of the same name; a name that is not valid for a pose.
MIEN_API Expected<std::string> morph_text(const Face& rest,
                                          const std::vector<MorphTarget>& targets);

/// The face with the file's targets added to its poses. Errors as for read_face: unknown names, too few
/// or too many numbers, a name that the face already has.
MIEN_API Expected<Face> read_morphs(const Face& face, const std::filesystem::path& path);
MIEN_API Expected<Face> read_morphs_text(const Face& face, std::string_view text,
                                         std::string_view name = "morphs");

}  // namespace mien
