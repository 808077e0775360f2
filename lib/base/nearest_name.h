#pragma once
// Which known name was probably meant.

#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// The least number of letters inserted, deleted, replaced or swapped with their neighbour that
/// turns a into b (optimal string alignment); anything above `most` is reported as most + 1.
int edit_distance(std::string_view a, std::string_view b, int most);

/// The name that was probably meant: the same in other letters ("Head_Turn"), what people call it
/// (`meanings`; it may be an option with what follows it), one with a third of its letters wrong at
/// most, or the only one with that word in it. Empty rather than a wrong one. The first of equals.
std::string_view nearest_name(std::string_view wanted, const std::vector<std::string_view>& names);

/// `no WHAT named "wanted"; did you mean "nearest"?`. If nothing is near, all names stand there if
/// a sentence holds them: `no WHAT named "wanted"; there are "a", "b" and "c"`.
std::string unknown_name(std::string_view what, std::string_view wanted,
                         const std::vector<std::string_view>& names);

}  // namespace mien
