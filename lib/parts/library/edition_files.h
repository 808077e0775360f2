#pragma once
// Which files an edition is made of. Its folder holds what is new in it, beside the edition before; a folder with a
// topology begins anew.

#include "lib/parts/library/shipped_parts.h"

#include <string_view>
#include <vector>

namespace mien {

inline constexpr std::string_view kTopologyFile = "topology.json";

/// The files of an edition, those of older folders first. `folders`: by their sign.
std::vector<ShippedPart> edition_files(std::span<const ShippedFolder> folders, char edition);

/// The newest of these that is frozen; the trial one if none is.
char newest_of(std::string_view signs);

}  // namespace mien
