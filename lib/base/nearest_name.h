#pragma once
// Which known name was probably meant.

#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// The least number of letters inserted, deleted, replaced or swapped with their neighbour that
/// turns a into b (optimal string alignment); anything above `most` is reported as most + 1.
int edit_distance(std::string_view a, std::string_view b, int most);

/// The name nearest to `wanted`, the first of equals; empty if none is within half its length (at
/// most 8 edits).
std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& names);

/// `no WHAT named "wanted"; did you mean "nearest"?`, or without the question if nothing is near.
std::string unknown_name(std::string_view what, std::string_view wanted,
                         const std::vector<std::string_view>& names);

}  // namespace mien
