#pragma once
// Points of a mesh bound to named points of a face, so that a head with targets moves it.
//
//   {"format": "mien-map", "format_version": 1,
//    "scale": 0.012,
//    "points": {"mouth/spine/0": 1734, "mouth/spine/1": [88, 91, 95]}}
//
// A point is a vertex of the OBJ files, counted from 0, or several: their middle. x goes to x and y
// to y; z, the depth, is left out. Without a scale it is the one that makes the bound points of the
// neutral mesh as wide spread as those of the face.

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
  double scale = 0;  ///< face units per unit of the mesh; 0: to be found
};

/// Reads a map for a face. Errors as read_face's: names that are no points of the face, with the
/// nearest one; vertices that are none.
MIEN_API Expected<ObjMap> read_obj_map(const Face& face, const std::filesystem::path& path);
MIEN_API Expected<ObjMap> read_obj_map_text(const Face& face, std::string_view text,
                                            std::string_view name = "map");

/// A morph file (morph_file.h) whose poses move the bound points as each target moves the neutral
/// mesh. Errors: a binding beyond the mesh; targets with other numbers of points; no spread to find
/// a scale from.
MIEN_API Expected<std::string> morph_text_from_meshes(
    const Face& face, const ObjMap& map, const Mesh& neutral,
    const std::vector<std::pair<std::string, Mesh>>& targets);

}  // namespace mien
