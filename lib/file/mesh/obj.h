#pragma once
// Reads points and faces of Wavefront OBJ files; faces are cut into triangles.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/mesh.h>

#include <filesystem>
#include <string_view>

namespace mien {

/// Reads a mesh. Points keep the file's order, so that files of one head in several expressions match
/// point by point. The error's `where` is "FILE:LINE" if one line is to blame: a point without three
/// finite numbers, or a face that names a missing point. Materials are ignored.
MIEN_API Expected<Mesh> read_obj(const std::filesystem::path& path);
MIEN_API Expected<Mesh> read_obj_text(std::string_view text, std::string_view name = "mesh");

/// Whether a target has as many points as the neutral mesh; the error names the file.
MIEN_API Expected<Done> check_fits(const Mesh& neutral, const Mesh& target,
                                   const std::filesystem::path& path);

}  // namespace mien
