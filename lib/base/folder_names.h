#pragma once
#include <mien/api.h>
#include <mien/expected.h>

#include <filesystem>
#include <string>
#include <vector>

namespace mien {

/// What is in a folder, in any order, without "." and "..". The iterators of the standard library of GCC 12 end the
/// program where memory runs out; this throws std::bad_alloc.
MIEN_API Expected<std::vector<std::string>> folder_names(const std::filesystem::path& folder);

}  // namespace mien
