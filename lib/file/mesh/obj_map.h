#pragma once
// Binds points of a mesh to named points of a face, so that the mesh's targets move the face.
//
//   {"format": "mien-map", "format_version": 1,
//    "scale": 0.012,
//    "points": {"mouth/spine/0": 1734, "mouth/spine/1": [88, 91, 95]}}
//
// A point is bound to one vertex of the OBJ files, counted from 0, or to the mean of several. x maps to x
// and y to y; z, the depth, is dropped. Without "scale", the scale is chosen so that the bound points of
// the neutral mesh have the same spread as those of the face.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/face.h>
#include <mien/mesh.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien {

struct ObjMap {
  struct Binding {
    int slice;                  ///< a point of the face
    std::vector<int> vertices;  ///< at least 1
  };
  std::vector<Binding> bindings;
  double scale = 0;  ///< face units per unit of the mesh; 0: found from the spread
};

/// Reads a map for a face. Errors as for read_face: a name that is no point of the face, with the nearest
/// one that is; something that is no vertex.
MIEN_API Expected<ObjMap> read_obj_map(const Face& face, const std::filesystem::path& path);
MIEN_API Expected<ObjMap> read_obj_map_text(const Face& face, std::string_view text,
                                            std::string_view name = "map");

/// A morph file (morph_file.h) whose poses move the bound points as each target moves the neutral
/// mesh. Errors: a binding to a vertex that the mesh does not have; a target with another number of
/// points; bound points without any spread, so that there is no scale.
MIEN_API Expected<std::string> morph_text_from_meshes(
    const Face& face, const ObjMap& map, const Mesh& neutral,
    const std::vector<std::pair<std::string, Mesh>>& targets);

}  // namespace mien
