#pragma once
// A face together with the tree of its file, and where in it each slice stands.

#include <mien/face.h>
#include <mien/face_limits.h>
#include <mien/letters.h>
#include "lib/file/json/json_tree.h"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace mien {

/// Where a slice's numbers stand.
struct SlicePlace {
  std::int32_t node = -1;  ///< of the tree; −1: no node of the file holds them
  bool mirrored = false;   ///< whether they are written as those of the other side
};
using SlicePlaces = std::vector<SlicePlace>;  ///< in the layout's order

struct PlacedFace {
  JsonTree tree;  ///< of the text, which must outlive it
  Face face;
  SlicePlaces places;
};

/// Reads a face from memory, as read_face_text does. The slices of a recipe stand nowhere: they are made of parts.
/// `folder`: of the file that the text was in; null: in none.
Expected<PlacedFace> read_placed_face(std::string_view text, std::string_view name,
                                      const std::filesystem::path* folder, const FaceLimits& limits,
                                      const Letters& letters,
                                      std::vector<Error>* warnings = nullptr);

}  // namespace mien
