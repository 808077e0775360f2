#pragma once
// Files into memory, whole.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace mien {

/// All bytes of a file, or of a pipe up to its end. Errors: a directory; a file that cannot be read, and
/// why; more than `most` bytes, which are then not read. Their `where` is the file's name.
Expected<std::string> read_bytes(const std::filesystem::path& path, std::size_t most);

}  // namespace mien
