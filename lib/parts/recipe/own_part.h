#pragma once
// Part files of one's own, outside a recipe's folder: read, begun, worn.

#include <mien/recipe.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A part file, and the family that it names.
struct FoundPart {
  std::string family;
  OwnPart part;
};

/// Reads a part file. The error has its place: no JSON, no part, a family that is not known. The rest is
/// looked at when it is worn.
Expected<FoundPart> read_part_file(const std::filesystem::path& path);

/// The part files of a folder, whose names end with ".part.json", by name. An error if there are none, or
/// if one cannot be read.
Expected<std::vector<FoundPart>> read_part_folder(const std::filesystem::path& folder);

/// Puts a part on, whatever it was.
void wear(Recipe& recipe, const FoundPart& part);

/// The text of a part file to begin with: one of the family's shipped parts, explained. Errors: an unknown
/// family, a name that no part may have.
Expected<std::string> part_skeleton(std::string_view family, std::string_view name);

}  // namespace mien
