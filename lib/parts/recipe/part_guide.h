#pragma once
// What the names in the part files of each family mean.

#include <string_view>

namespace mien {

/// Lines of at most 112 signs for those who draw a part of the family: they explain every point and value that its
/// parts tell others, and every number of the library that moves them. Empty: there are none.
std::string_view part_guide(std::string_view family);

}  // namespace mien
